// Which accesses are bounds-checked: those that are not proved to be in bounds. And the arithmetic over symbolic sizes
// that the proofs use.
#include "lower/analysis/symbolic.h"
#include "lowered.h"

#include <gmock/gmock.h>

namespace gliftc {
namespace {

using testing::HasSubstr;
using testing::Not;

using lower::symbolic::number;
using lower::symbolic::Sum;
using lower::symbolic::Symbols;
using lower::symbolic::operator+;
using lower::symbolic::operator-;
using lower::symbolic::operator*;

TEST(Symbols, SignsOfSums) {
    Symbols symbols;
    const Sum m = symbols.size(1), n = symbols.size(1);
    EXPECT_TRUE(symbols.is_natural(m * n - number(1)));
    EXPECT_TRUE(symbols.is_natural(m * n - n));
    EXPECT_FALSE(symbols.is_natural(m * n - number(2)));
    EXPECT_FALSE(symbols.is_natural(m - n));
}

TEST(Symbols, EndsOfWhatVaries) {
    Symbols symbols;
    const Sum m = symbols.size(1), n = symbols.size(1);
    const Sum x = symbols.varying({number(0), m - number(1)}), y = symbols.varying({number(0), n - number(1)});
    EXPECT_EQ(symbols.highest(y * m + x), m * n - number(1));
    EXPECT_EQ(symbols.highest(y * m + (m - number(1) - x)), m * n - number(1));
    EXPECT_EQ(symbols.lowest(m - x), number(1));
    EXPECT_EQ(symbols.highest(symbols.varying({number(0), {}})), std::nullopt);
    // A sum with products of varying numbers: y (y + 1) + x.
    EXPECT_EQ(symbols.highest(y * y + y + x), n * n - n + m - number(1));
}

TEST(Symbols, QuotientAndRest) {
    Symbols symbols;
    const Sum m = symbols.size(1), n = symbols.size(1);
    const auto [whole, rest] = lower::symbolic::divided(m * n * number(3) - number(1), m);
    EXPECT_EQ(whole, n * number(3));
    EXPECT_EQ(rest, number(-1));
    const auto [blocks, more] = lower::symbolic::divided(m - number(1), number(64));
    EXPECT_EQ(blocks, number(-1));
    EXPECT_EQ(more, m + number(63));
}

/// Whether accesses are bounds-checked in a structure whose translator, from uint2 addresses, has this body.
bool is_guarded(const std::string& memory, const std::string& body, const std::string& result = "uint") {
    const Lowering lowering("translator T : uint2 -> " + result + " { extent: uint2; domain() { return extent; } " +
                            "translate(va) { " + body + " } }\n" + "structure S(extent: uint2) { memory data = " +
                            memory + "; via T(extent); }\n" + "kernel k(s: inout each<S>) { s = 2.0 * s; }");
    return lowering.direct("k").find("data_extent") != std::string::npos;
}

TEST(Contained, RowsFoldsTilesAndBits) {
    const std::string all = "buffer<float>[extent.x * extent.y]";
    EXPECT_FALSE(is_guarded(all, "return va.y * extent.x + va.x;"));
    EXPECT_FALSE(is_guarded(all, "return va.x * extent.y + va.y;"));
    EXPECT_FALSE(is_guarded(all, "return va.y * extent.x + (extent.x - 1u - va.x);"));
    EXPECT_FALSE(is_guarded(all, "return va.y * extent.x + select(va.y % 2u == 0u, va.x, extent.x - 1u - va.x);"));
    EXPECT_FALSE(is_guarded(all, "return va.y * extent.x + (va.x + 7u * va.y) % extent.x;"));
    EXPECT_FALSE(is_guarded("buffer<float>[64]", "return (va.x * 31u + va.y) % 64u;"));
    EXPECT_FALSE(is_guarded("buffer<float>[64]", "return (va.x * 31u + va.y) & 63u;"));
    EXPECT_FALSE(is_guarded("buffer<float>[64]", "return min(va.x * 31u + va.y, 63u);"));
    EXPECT_FALSE(is_guarded("buffer<float>[64]", "return clamp(va.x, 3u, 63u);"));
    EXPECT_FALSE(is_guarded("image2d<float>(uint2(32, (extent.x * extent.y + 31u) / 32u))",
                            "let i = va.y * extent.x + va.x; return uint2(i % 32u, i / 32u);", "uint2"));
    EXPECT_FALSE(is_guarded("image2d<float>(uint2(32, extent.x * extent.y / 32u + 1u))",
                            "let i = va.y * extent.x + va.x; return uint2(i % 32u, i / 32u);", "uint2"));
    EXPECT_FALSE(is_guarded("image2d<float>(extent)", "return va;", "uint2"));
    EXPECT_FALSE(is_guarded("image2d<float>(extent.yx)", "return va.yx;", "uint2"));
    EXPECT_FALSE(
        is_guarded("buffer<float>[extent.x * (extent.x + 1u) / 2u + extent.y]", "return va.x * (va.x + 1u) / 2u;"));
}

TEST(Contained, ConditionsBound) {
    const std::string all = "buffer<float>[extent.x * extent.y]";
    const std::string rest = "return va.y * extent.x + va.x;";
    EXPECT_FALSE(is_guarded(all, "if !all(lessThan(va, extent)) { return none; } " + rest, "uint?"));
    EXPECT_FALSE(is_guarded(all, "if va.x >= extent.x || va.y >= extent.y { return none; } " + rest, "uint?"));
    EXPECT_FALSE(is_guarded(all, "if va.x < extent.x && va.y < extent.y { " + rest + " } return none;", "uint?"));
    EXPECT_FALSE(is_guarded("buffer<float>[extent.x]", "return select(va.x + 1u < extent.x, va.x + 1u, 0u);"));
    EXPECT_TRUE(is_guarded(all, "if va.x >= extent.x { return none; } " + rest, "uint?"));
    EXPECT_TRUE(is_guarded(all, "if va.x > extent.x || va.y >= extent.y { return none; } " + rest, "uint?"));
    // x + 1 may wrap around, so a bound on it gives none on x.
    EXPECT_TRUE(
        is_guarded("buffer<float>[extent.x]", "if va.x + 1u < extent.x { return va.x; } return none;", "uint?"));
}

TEST(Contained, WhatMayLieBeyond) {
    EXPECT_TRUE(is_guarded("buffer<float>[extent.x * extent.y]", "return va.y * extent.x + va.x + 1u;"));
    EXPECT_TRUE(is_guarded("buffer<float>[extent.x * extent.y - 1u]", "return va.y * extent.x + va.x;"));
    EXPECT_TRUE(is_guarded("buffer<float>[extent.x * extent.y]", "return va.y * extent.y + va.x;"));
    EXPECT_TRUE(is_guarded("buffer<float>[extent.x]", "return va.x - 1u;"));
    EXPECT_TRUE(is_guarded("buffer<float>[extent.x]", "return extent.x - va.x;"));
    EXPECT_TRUE(is_guarded("buffer<float>[extent.x]", "return va.y;"));
    EXPECT_TRUE(is_guarded("buffer<float>[extent.x]", "return va.x ^ 5u;"));
    EXPECT_TRUE(is_guarded("buffer<float>[64]", "return (va.x * 31u + va.y) % 65u;"));
    EXPECT_TRUE(is_guarded("buffer<float>[64]", "return va.x | 63u;"));
    EXPECT_TRUE(is_guarded("image2d<float>(extent)", "return va.yx;", "uint2"));
    // The domain and so the memory may be empty, but the translator returns addresses even then.
    EXPECT_TRUE(is_guarded("buffer<float>[extent.x * extent.y]",
                           "let a = min(va, max(extent, 1u) - 1u); return a.y * extent.x + a.x;", "uint?"));
}

TEST(Contained, SumsOfSizesMayWrap) {
    const std::string large = "extent.x * 65536u * 65536u";
    EXPECT_TRUE(is_guarded("buffer<float>[extent.x]", "return va.x + (" + large + " < extent.x ? extent.x : 0u);"));
    EXPECT_TRUE(is_guarded("buffer<float>[extent.x]", "return va.x + (extent.x - min(extent.x, " + large + "));"));
    EXPECT_TRUE(is_guarded("buffer<float>[extent.x]", "return va.x + max(extent.x, " + large + ") - " + large + ";"));
    EXPECT_TRUE(is_guarded("buffer<float>[extent.x]", "return va.x / (" + large + ") + va.x;"));
    EXPECT_TRUE(is_guarded("buffer<float>[extent.x]", "return va.x + 1u - va.x % (" + large + ") - 1u;"));
    // The runtime makes no memory whose size would wrap.
    EXPECT_FALSE(is_guarded("buffer<float>[" + large + " + 1u]", "return va.x < " + large + " ? va.x : 0u;"));
}

/// Whether accesses are bounds-checked in a structure with these members, a memory of `extent` floats, and this
/// translator.
bool is_guarded_line(const std::string& members, const std::string& extent, const std::string& translator) {
    const Lowering lowering(
        "translator Same : uint -> uint { n: uint; domain() { return n; } translate(va) { return va; } }\n"
        "translator EndOf : uint -> uint { of: Line; n: uint; domain() { return n; } "
        "translate(va) { return min(va + of.domain(), of.domain()); } }\n"
        "structure Line(n: uint) { memory data = buffer<float>[n]; via Same(n); }\n"
        "structure Through(given: Line) { memory elements = given; }\n"
        "structure S(one: Line, two: Line) { " +
        members + " memory kept = buffer<float>[" + extent + "]; via " + translator +
        "; domain() { return one.domain(); } }\n"
        "kernel k(x: in any<S>, to: out each<Line>) { to = x[position()]; }");
    return lowering.direct("k").find("kept_extent") != std::string::npos;
}

TEST(Contained, StructuresThatMembersAreGiven) {
    const std::string both = "structure a = Through(one); structure b = Through(two);";
    EXPECT_FALSE(is_guarded_line(both, "one.domain()", "Same(a.domain())"));
    EXPECT_FALSE(is_guarded_line(both, "a.domain()", "Same(one.domain())"));
    EXPECT_TRUE(is_guarded_line(both, "b.domain()", "Same(a.domain())"));
    EXPECT_TRUE(is_guarded_line(both, "two.domain()", "Same(a.domain())"));
    EXPECT_TRUE(is_guarded_line(both, "b.domain()", "Same(one.domain())"));
}

TEST(Contained, StructuresOfTranslators) {
    EXPECT_FALSE(is_guarded_line("", "one.domain() + 1u", "EndOf(one, one.domain())"));
    EXPECT_FALSE(is_guarded_line("", "two.domain() + 1u", "EndOf(two, one.domain())"));
    EXPECT_TRUE(is_guarded_line("", "one.domain() + 1u", "EndOf(two, one.domain())"));
}

TEST(Contained, AnyAccessAsks) {
    const std::string direct =
        Lowering("kernel k(s: in any<Sparse>, a: at<Field>, g: out each<Field>) { g = s[a]; }").direct("k");
    EXPECT_THAT(direct, HasSubstr("s_value_inside: bool = s_entry.resident && (s_place < $s_pages_extent);"));
    EXPECT_THAT(Lowering("kernel k(f: in any<Flat>, a: at<Field>, g: out each<Field>) { g = f[a]; }").direct("k"),
                Not(HasSubstr("f_place")));
}

}  // namespace
}  // namespace gliftc
