#include "parse_text.h"

#include <gtest/gtest.h>

namespace gliftc::test {
namespace {

TEST(Modules, have_names_docs_and_imports) {
    EXPECT_EQ(
        Parsed("/// What it is.\n/// And more.\nmodule a.b;\nuse std.array;\nuse ./mesh;\nuse ../lib/other;\n")
            .printed(),
        "(module a.b doc \"What it is.\\nAnd more.\"\n  (use std.array)\n  (use ./mesh)\n  (use ../lib/other))\n");
}

TEST(Docs, belong_to_what_follows) {
    EXPECT_EQ(
        declarations("/// A point.\nstruct P {\n    /// To the right.\n    x: float;\n    // no doc\n    y: float;\n}"),
        "  (struct P doc \"A point.\"\n    (field x:float doc \"To the right.\")\n    (field y:float))");
}

TEST(Functions, have_generics_and_results) {
    EXPECT_EQ(
        declarations("pub fn f<N: uint, T: type = float>(a: vec<N, T>, b: T) -> T? { return none; }"),
        "  (pub fn f <N:uint> <T:type = float> ((a (generic vec N T)) (b T)) -> (optional T)\n    (return none))");
}

TEST(Statements, are_read) {
    EXPECT_EQ(declarations("fn f() {\n"
                           "    let a = 1; var b: float = 2.0; const c = 3;\n"
                           "    b += a; s[i, j].x <<= 2; g = sum; f(a);\n"
                           "    if let v = s.find(a) { return v; } else if a < b { break; } else { continue; }\n"
                           "    for i in 0..4 { } while true { { } }\n"
                           "    return;\n"
                           "}"),
              "  (fn f ()\n"
              "    (let a 1)\n"
              "    (var b:float 2)\n"
              "    (const c 3)\n"
              "    (+= b a)\n"
              "    (<<= (. (index s i j) x) 2)\n"
              "    (= g sum)\n"
              "    (do (call f a))\n"
              "    (if let v (call (. s find) a)\n"
              "      (return v)\n"
              "    else\n"
              "      (if (< a b)\n"
              "        (break)\n"
              "      else\n"
              "        (continue)))\n"
              "    (for i (.. 0 4))\n"
              "    (while true\n"
              "      (block))\n"
              "    (return))");
}

TEST(Kernels, have_access_patterns) {
    EXPECT_EQ(declarations(
                  "pub kernel k(f: in near<Field, 1>, g: out each<Field>, h: inout each<S>, a: at<S>, b: in any<S>,\n"
                  "             c: out scatter<S, min>, dt: float) group(8, 8) { shared tile: float[64]; }"),
              "  (pub kernel k ((f in near Field 1) (g out each Field) (h inout each S) (a at S) (b in any S) "
              "(c out scatter S min) (dt float)) group 8 8\n"
              "    (shared tile:(index float 64)))");
}

TEST(Kernels, have_unnamed_generic_parameters) {
    EXPECT_EQ(
        declarations("kernel k(f: in near<2>, a: at, g: out each<Structure<uint, T>>, c: out scatter<_, add>) { }"),
        "  (kernel k <structure of f> <structure of g:(generic Structure uint T)> <structure of c> "
        "<structure of a = structure of g> ((f in near structure of f 2) (a at structure of a) "
        "(g out each structure of g) (c out scatter structure of c add)))");
    EXPECT_EQ(declarations("fn f(x: near<1>, y: any) { }"),
              "  (fn f <structure of x> <structure of y> ((x near structure of x 1) (y any structure of y)))");
}

TEST(Translators, have_fields_and_methods_without_types) {
    EXPECT_EQ(declarations("@total\ntranslator Fold<N: uint> : vec<N, uint> -> uint2 {\n    extent: vec<N, uint>;\n"
                           "    translate(va) { return va; }\n    fn other(x: uint) -> uint { return x; }\n}"),
              "  (@total translator Fold <N:uint> (generic vec N uint) -> uint2\n"
              "    (field extent:(generic vec N uint))\n"
              "    (fn translate ((va))\n      (return va))\n"
              "    (fn other ((x uint)) -> uint\n      (return x)))");
    EXPECT_EQ(declarations("translator T<N: uint> = Fold<N> then Linear;"),
              "  (alias T <N:uint> (then (generic Fold N) Linear))");
}

TEST(Structures, have_items) {
    EXPECT_EQ(
        declarations(
            "structure A<T: type, edge: Boundary = none>(extent: uint2) {\n"
            "    memory data = image2d<T>(extent) mips(3) filter linear compare less;\n"
            "    structure table = B<2>(extent);\n"
            "    if edge == Boundary.none { via Fold<2>(extent); } else { via C(table) then D; otherwise T(0); }\n"
            "    domain() { return extent; }\n"
            "}"),
        "  (structure A <T:type> <edge:Boundary = none> ((extent uint2))\n"
        "    (memory data (call (generic image2d T) extent) mips 3 filter linear compare less)\n"
        "    (member table (call (generic B 2) extent))\n"
        "    (if (== edge (. Boundary none))\n"
        "      (via (call (generic Fold 2) extent))\n"
        "    else\n"
        "      (via (then (call C table) D))\n"
        "      (otherwise (call T 0)))\n"
        "    (fn domain ()\n      (return extent)))");
}

TEST(Views, compute_elements) {
    EXPECT_EQ(declarations("structure Rows<axis: uint>(coc: Circles) : uint2 -> Row { at(p) { return p; } }"),
              "  (structure Rows <axis:uint> ((coc Circles)) uint2 -> Row\n    (fn at ((p))\n      (return p)))");
}

TEST(Adaptors, have_host_state_and_pipelines) {
    EXPECT_EQ(
        declarations(
            "structure Stack<T: type>(n: uint) {\n    structure items = Array<1, T>(n);\n    host top: uint = 0;\n"
            "    pub pipeline push(values: in range<1, T>) { copy(values, items[top .. top + n]); top += n; }\n"
            "    pipeline pop() -> range<1, T> { return items[0..n]; }\n}"),
        "  (structure Stack <T:type> ((n uint))\n"
        "    (member items (call (generic Array 1 T) n))\n"
        "    (host top:uint 0)\n"
        "    (pub pipeline push ((values in range 1 T))\n"
        "      (do (call copy values (index items (.. top (+ top n)))))\n"
        "      (+= top n))\n"
        "    (pipeline pop () -> range 1 T\n"
        "      (return (index items (.. 0 n)))))");
}

TEST(Enums, may_have_an_enumerator_none) {
    EXPECT_EQ(declarations("enum Boundary { none, clamp = 2, }"), "  (enum Boundary none clamp=2)");
}

TEST(Tests, have_titles) {
    EXPECT_EQ(declarations("test \"it works\" { temp f = Field(uint2(8, 8)); expect(true); }"),
              "  (test \"it works\"\n    (temp f (call Field (call uint2 8 8)))\n    (do (call expect true)))");
}

TEST(ExternStructs, name_their_header) {
    EXPECT_EQ(declarations("extern struct P from \"particle.hpp\";"), "  (extern struct P from \"particle.hpp\")");
}

TEST(Interfaces, have_functions_without_bodies) {
    EXPECT_EQ(
        declarations("interface Paged<N: uint> { fn page(va: vec<N, uint>) -> uint; entry(p: uint); }"),
        "  (interface Paged <N:uint>\n    (fn page ((va (generic vec N uint))) -> uint)\n    (fn entry ((p uint))))");
}

}  // namespace
}  // namespace gliftc::test
