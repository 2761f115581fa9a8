#include "parse_text.h"

#include "syntax/format.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace gliftc::test {
namespace {

std::string formatted(const std::string& text) {
    Sources sources;
    Names names;
    Diagnostics diagnostics;
    auto result = format(sources.add("test.glift", text), sources, names, diagnostics);
    return result ? *result : "<errors>";
}

TEST(Format, lays_statements_out) {
    EXPECT_EQ(formatted("module   m ;\n\n\n\nuse std . array;use ./a/b;\n"
                        "pub   kernel k( f:in near< S,1 >,g : out each<S> )group( 8,8 )\n{\nvar x=-1.0*f [ 0 ];\n"
                        "for i in 0 .. 4 {\nif a<b{ x+=1 ; }else{ x=vec<2,vec<3,uint>>( 1 ).x; }\n}\n\n\n// "
                        "note\ng=a?b:c; // why\n}\n"),
              "module m;\n\nuse std.array;\nuse ./a/b;\n"
              "pub kernel k(f: in near<S, 1>, g: out each<S>) group(8, 8) {\n"
              "    var x = -1.0 * f[0];\n"
              "    for i in 0 .. 4 {\n"
              "        if a < b { x += 1; } else { x = vec<2, vec<3, uint>>(1).x; }\n"
              "    }\n\n"
              "    // note\n"
              "    g = a ? b : c;  // why\n"
              "}\n");
}

TEST(Format, lays_bare_patterns_out) {
    EXPECT_EQ(formatted("module m;\nkernel k(a:at,f : in  near< 1 >,g:out   each,c:out scatter<_,add>){g=f[0];}\n"),
              "module m;\nkernel k(a: at, f: in near<1>, g: out each, c: out scatter<_, add>) { g = f[0]; }\n");
}

TEST(Format, lays_cases_out) {
    EXPECT_EQ(
        formatted("module m;\nfn f(x: int) -> int {\nswitch x {\n1 :{ return 1; } 2,-4 .. 5: {\nreturn 2; } // two\n"
                  "else :{ return 3; }}\n}\nfn g(p: Pair<A : int,B:uint>){ }\n"),
        "module m;\n"
        "fn f(x: int) -> int {\n"
        "    switch x {\n"
        "        1: { return 1; }\n"
        "        2, -4 .. 5: {\n"
        "            return 2;\n"
        "        }  // two\n"
        "        else: { return 3; }\n"
        "    }\n"
        "}\n"
        "fn g(p: Pair<A: int, B: uint>) { }\n");
}

TEST(Format, lays_closures_out) {
    EXPECT_EQ(formatted("module m;\npipeline p() {\nf( x ,| a ,b : float | a*b,||1 );\nf(x, |a|{ return a ; });\n"
                        "if f(x, |a| {\nlet b=a; // why\n\nreturn b; }) { g(); }\n}\n"),
              "module m;\npipeline p() {\n"
              "    f(x, |a, b: float| a * b, || 1);\n"
              "    f(x, |a| { return a; });\n"
              "    if f(x, |a| {\n"
              "        let b = a;  // why\n\n"
              "        return b;\n"
              "    }) {\n"
              "        g();\n"
              "    }\n"
              "}\n");
}

TEST(Format, keeps_short_blocks_and_breaks_long_lines) {
    std::string text =
        "module m;\nfn f(first_parameter: vec<3, float>, second_parameter: vec<3, float>, third_parameter: float, "
        "fourth_parameter: float) -> float { return 1.0; }\n";
    EXPECT_EQ(formatted(text),
              "module m;\n"
              "fn f(first_parameter: vec<3, float>, second_parameter: vec<3, float>, third_parameter: float,\n"
              "     fourth_parameter: float) -> float {\n"
              "    return 1.0;\n"
              "}\n");
}

TEST(Format, knows_what_a_token_means) {
    EXPECT_EQ(
        formatted(
            "module m;\nfn f(a:float?,b:A<B<C<D<uint ? ?>>>>)->uint2??{ return a<b&&c> -d ? await x : !y ?? z; }\n"
            "@total @cost( 1 )\ntranslator T:uint->uint?{ n:uint; translate(a){ return none; } }\n"
            "enum E{none,some}\nenum F{\nnone,\nsome}\n"),
        "module m;\nfn f(a: float?, b: A<B<C<D<uint?"
        "?>>>>) -> uint2?? { return a < b && c > -d ? await x : !y ?? z; }\n"
        "@total @cost(1)\ntranslator T : uint -> uint? { n: uint; translate(a) { return none; } }\n"
        "enum E { none, some }\nenum F {\n    none,\n    some\n}\n");
}

TEST(Format, aligns_comments_behind_neighbouring_lines) {
    EXPECT_EQ(
        formatted("module m;\nstruct S {\n    a: float; // x\n    longer: uint3; // y\n\n    b: float; // z\n}\n"),
        "module m;\nstruct S {\n    a: float;       // x\n    longer: uint3;  // y\n\n    b: float;  // z\n}\n");
}

TEST(Format, leaves_files_with_errors_alone) { EXPECT_EQ(formatted("module m; fn ("), "<errors>"); }

/// Expects that formatting a text keeps its syntax tree and is idempotent. A text with errors is skipped.
void expect_kept(const std::string& text, const std::string& where) {
    Parsed before(text);
    if (before.diagnostics.has_errors()) return;
    std::string once = formatted(text);
    EXPECT_EQ(Parsed(once).printed(), before.printed()) << where;
    EXPECT_EQ(formatted(once), once) << where;
}

TEST(Format, keeps_the_meaning_of_every_file_of_the_project) {
    std::size_t seen = 0;
    for (const char* folder : {"/stdlib", "/examples", "/tests/golden", "/tests/errors"}) {
        std::error_code error;
        for (std::filesystem::recursive_directory_iterator entry(std::string(GLIFT_SOURCE_DIR) + folder, error), end;
             entry != end; ++entry) {
            if (entry->path().extension() != ".glift") continue;
            std::ifstream file(entry->path());
            std::stringstream text;
            text << file.rdbuf();
            expect_kept(text.str(), entry->path().string());
            ++seen;
        }
    }
    EXPECT_GT(seen, 10u);
}

TEST(Format, keeps_comments_wherever_they_stand) {
    expect_kept(
        "// first\nmodule m; // second\n/* third */\n\nfn f(a: int, // fourth\n     b: int) /* fifth */ { // sixth\n"
        "    // seventh\n    return a /* eighth */ + b; // ninth\n    // tenth\n}\n// eleventh\nenum E { // twelfth\n  "
        "  a, // x\n"
        "    // y\n    b }\nfn g() { if a { } // z\n else { } }\n/* many\n   lines */\n",
        "comments");
    std::string text = formatted("module m;\nfn f() { // sixth\n    g(); // ninth\n    // tenth\n}\n");
    EXPECT_EQ(text, "module m;\nfn f() {  // sixth\n    g();  // ninth\n    // tenth\n}\n");
    // A line comment before a '{' does not swallow it.
    expect_kept("module m;\nfn f() // before\n{\n    if a // again\n    { g(); }\n}\n", "comments before blocks");
}

}  // namespace
}  // namespace gliftc::test
