#include "parse_text.h"

#include <gtest/gtest.h>

namespace gliftc::test {
namespace {

TEST(Expressions, have_the_precedence_of_c) {
    EXPECT_EQ(expression("a + b * c - d"), "(- (+ a (* b c)) d)");
    EXPECT_EQ(expression("a << b + c < d == e & f ^ g | h && i || j"),
              "(|| (&& (| (^ (& (== (< (<< a (+ b c)) d) e) f) g) h) i) j)");
    EXPECT_EQ(expression("-a * !b + ~c"), "(+ (* (- a) (! b)) (~ c))");
    EXPECT_EQ(expression("(a + b) * c"), "(* (+ a b) c)");
    EXPECT_EQ(expression("a ? b : c ? d : e"), "(?: a b (?: c d e))");
}

TEST(Expressions, put_otherwise_below_or_and_above_the_conditional) {
    EXPECT_EQ(expression("a || b ?? c ? d : e"), "(?: (?? (|| a b) c) d e)");
    EXPECT_EQ(expression("x ?? y ?? z"), "(?? (?? x y) z)");
}

TEST(Expressions, put_the_range_below_all_else) {
    EXPECT_EQ(expression("a + 1 .. b ? c : d"), "(.. (+ a 1) (?: b c d))");
    EXPECT_EQ(expression("items[top .. top + n]"), "(index items (.. top (+ top n)))");
}

TEST(Expressions, read_a_range_of_integers_without_spaces) {
    EXPECT_EQ(expression("1..2"), "(.. 1 2)");
    EXPECT_EQ(expression("1.5..2.5"), "(.. 1.5 2.5)");
}

TEST(Expressions, compose_with_then_last) {
    EXPECT_EQ(expression("Fold<N> then Linear(a, b) then Tile"),
              "(then (then (generic Fold N) (call Linear a b)) Tile)");
}

TEST(Expressions, await_like_a_prefix_operator) {
    EXPECT_EQ(expression("await g[uint2(1, 2)] + 1"), "(+ (await (index g (call uint2 1 2))) 1)");
}

TEST(Expressions, read_literals) {
    EXPECT_EQ(expression("f(1, 2u, 3l, 4ul, 0xff, 0XABu)"), "(call f 1 2u 3l 4ul 255 171u)");
    EXPECT_EQ(expression("f(1.0, 1e-4, 2.5f, 1.5h, 3.0d, 1e3)"), "(call f 1 1e-04 2.5f 1.5h 3d 1000)");
    EXPECT_EQ(expression("f(true, false, none)"), "(call f true false none)");
    EXPECT_EQ(expression(R"("a\n\"b\"")"), "\"a\n\"b\"\"");
    EXPECT_EQ(expression("18446744073709551615ul"), "18446744073709551615ul");
}

TEST(Expressions, read_tuples_and_named_arguments) {
    EXPECT_EQ(expression("{1, 2, 3}"), "(tuple 1 2 3)");
    EXPECT_EQ(expression("{x: 1, y: {2}}"), "(tuple x:1 y:(tuple 2))");
    EXPECT_EQ(expression("f(1, extent: 2)"), "(call f 1 extent:2)");
    EXPECT_EQ(expression("{}"), "(tuple)");
}

TEST(Expressions, read_closures) {
    EXPECT_EQ(expression("f(|a, b| a | b, 1)"), "(call f (closure ((a) (b)) (| a b)) 1)");
    EXPECT_EQ(expression("f(|x: vec<2, uint>| x ? 1 : 2)"), "(call f (closure ((x (generic vec 2 uint))) (?: x 1 2)))");
    EXPECT_EQ(expression("f(|| x || y)"), "(call f (closure () (|| x y)))");
    EXPECT_EQ(expression("f(|x| g(|y| x + y))"), "(call f (closure ((x)) (call g (closure ((y)) (+ x y)))))");
    EXPECT_EQ(expression("f(|x| { return x; })"), "(call f (closure ((x)) {\n  (return x)}))");
}

TEST(Expressions, read_any_word_after_a_dot) {
    EXPECT_EQ(expression("Boundary.none"), "(. Boundary none)");
    EXPECT_EQ(expression("a.xyz.in"), "(. (. a xyz) in)");
}

TEST(Generics, are_told_from_comparisons) {
    EXPECT_EQ(expression("a < b"), "(< a b)");
    EXPECT_EQ(expression("a < b && c > d"), "(&& (< a b) (> c d))");
    EXPECT_EQ(expression("a < b && c > (d)"), "(&& (< a b) (> c d))");
    EXPECT_EQ(expression("a < (b) ? c : d"), "(?: (< a b) c d)");
    EXPECT_EQ(expression("vec<N, uint>(1)"), "(call (generic vec N uint) 1)");
    EXPECT_EQ(expression("f(a < b, c > (d))"), "(call f (call (generic a b c) d))");
    EXPECT_EQ(expression("f(a < b, c > d)"), "(call f (< a b) (> c d))");
    EXPECT_EQ(expression("Foo<2>.size"), "(. (generic Foo 2) size)");
    EXPECT_EQ(expression("i < n - 1"), "(< i (- n 1))");
}

TEST(Generics, take_additive_expressions) {
    EXPECT_EQ(expression("Foo<N + 1, -2, M * 2>()"), "(call (generic Foo (+ N 1) (- 2) (* M 2)))");
    EXPECT_EQ(expression("Foo<(a > b), (1 << 2)>()"), "(call (generic Foo (> a b) (<< 1 2)))");
    EXPECT_EQ(expression("Foo<float?, T[8]>()"), "(call (generic Foo (optional float) (index T 8)))");
    EXPECT_EQ(expression("Foo<f(a < b)>()"), "(call (generic Foo (call f (< a b))))");
}

TEST(Generics, close_two_at_once) {
    EXPECT_EQ(expression("A<B<C<2>>>()"), "(call (generic A (generic B (generic C 2))))");
    EXPECT_EQ(expression("A<B<C<D<2>>>>()"), "(call (generic A (generic B (generic C (generic D 2)))))");
    EXPECT_EQ(type("A<B<C<D<E<2>>>>>"), "(generic A (generic B (generic C (generic D (generic E 2)))))");
    EXPECT_EQ(type("A<1, B<2, C<3, D<4>>>>"), "(generic A 1 (generic B 2 (generic C 3 (generic D 4))))");
    EXPECT_EQ(type("vec<2, vec<3, uint>>"), "(generic vec 2 (generic vec 3 uint))");
    EXPECT_EQ(expression("a >> b"), "(>> a b)");
    EXPECT_EQ(declarations("fn f() { let x: A<B<2>>= 1; let y: A<2>= 2; }"),
              "  (fn f ()\n    (let x:(generic A (generic B 2)) 1)\n    (let y:(generic A 2) 2))");
}

TEST(Types, have_suffixes) {
    EXPECT_EQ(type("float[8]"), "(index float 8)");
    EXPECT_EQ(type("vec<N, uint>?"), "(optional (generic vec N uint))");
    EXPECT_EQ(type("uint?\?"), "(optional (optional uint))");
    EXPECT_EQ(type("uint?\?\?[2]"), "(index (optional (optional (optional uint))) 2)");
    EXPECT_EQ(expression("A<uint?\?, B<float?\?>>()"),
              "(call (generic A (optional (optional uint)) (generic B (optional (optional float)))))");
    EXPECT_EQ(type("T[N * 2][3]?"), "(optional (index (index T (* N 2)) 3))");
    EXPECT_EQ(type("module_name.Type<2>"), "(generic (. module_name Type) 2)");
}

TEST(Names, may_be_words_that_mean_something_elsewhere) {
    for (const char* word : {"at",   "any",  "near",   "each",   "range",     "group",    "host",   "min",
                             "max",  "from", "filter", "domain", "memory",    "view",     "kernel", "test",
                             "type", "out",  "shared", "temp",   "structure", "pipeline", "compare"}) {
        EXPECT_EQ(expression(std::string(word) + " + 1"), "(+ " + std::string(word) + " 1)");
        std::string function =
            "fn f(" + std::string(word) + ": float) { let " + word + " = 1; " + word + " = 2; " + word + "(3); }";
        EXPECT_FALSE(Parsed("module m; " + function).diagnostics.has_errors()) << function;
    }
}

}  // namespace
}  // namespace gliftc::test
