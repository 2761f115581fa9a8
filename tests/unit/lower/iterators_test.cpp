#include "lowered.h"

#include <gmock/gmock.h>

namespace gliftc {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Iterators, StructuresOfOneStateShareTheAddress) {
    Lowering lowering("kernel copy(f: in each<Field>, g: out each<Field>) { g = f; }");
    std::string text = lowering.direct("copy");
    EXPECT_THAT(text, HasSubstr("g_data[f_at] = f_data[f_at];"));
    EXPECT_EQ(count(text, "parameter "), 1u) << text;
    text = lowering.general("copy");
    EXPECT_THAT(text, HasSubstr("g_data[g_at] = f_value;"));
    EXPECT_THAT(text, HasSubstr("let f_address: uint3 = $f_origin + address;"));
}

TEST(Iterators, NeighboursAreTheCentrePlusAStride) {
    Lowering lowering(
        "kernel k(f: in near<Field, 1>, g: out each<Field>) { g = f[int3(1, 0, 0)] + f[int3(0, 0, -1)]; }");
    std::string text = lowering.direct("k");
    EXPECT_THAT(text, HasSubstr("f_data[f_at + (f_xp1_inside ? 1u : 0u)]"));
    EXPECT_THAT(text, HasSubstr("let f_zm1_inside: bool = address.z >= 1u;"));
    EXPECT_EQ(count(text, "address.x + 1u"), 1u) << text;
    const ir::Pass& pass = lowering.forms("k").general;
    const ir::Variant* variant = interior_variant_for(pass, ir::Devices::host);
    ASSERT_NE(variant, nullptr);
    EXPECT_EQ(interior_variant_for(pass, ir::Devices::shaders), nullptr);
    EXPECT_EQ(variant->assumes.interior->radius, 1u);
    EXPECT_LT(variant->assumes.interior->domain, pass.parameters.size());
    std::string interior = ir::print(lowering.program, variant->body, &pass);
    EXPECT_THAT(interior, Not(HasSubstr("inside")));
}

TEST(Iterators, OnlyWhatIsNotAffineIsComputedAgain) {
    Lowering lowering("kernel k(f: in near<Flat, 1>, g: out each<Flat>) { g = f[int3(1, 0, 0)]; }");
    std::string text = lowering.direct("k");
    EXPECT_THAT(text, HasSubstr("f_xp1_i: uint = f_i + 1u;"));
    EXPECT_THAT(text, HasSubstr("binding f_data: image2d<float> read r32f sampled"));
}

TEST(Iterators, WhatATranslatorAsksOfTheCentreIsKnown) {
    Lowering lowering("kernel k(f: in near<Edged, 1>, g: out each<Edged>) { g = f[0] + f[int3(0, 1, 0)]; }");
    std::string text = lowering.direct("k");
    EXPECT_THAT(text, HasSubstr("let f_yp1_inside: bool = (address.y + 1u) < $f_extent.y;"));
    EXPECT_EQ(count(text, "lessThan"), 1u) << text;  // that of in_range
    EXPECT_THAT(text, Not(HasSubstr("if ")));
}

TEST(Iterators, RandomReadsAreGuarded) {
    Lowering lowering("kernel k(a: at<Field>, f: in any<Field>, g: out each<Field>) { g = f[a * 2u]; }");
    std::string text = lowering.direct("k");
    EXPECT_THAT(text, HasSubstr("all(lessThan(f_address, $a_extent))"));
    EXPECT_THAT(text, HasSubstr("f_value_inside ? f_value : 0.0"));
}

TEST(Iterators, PageTablesAreReadOnceAnElement) {
    Lowering lowering("kernel k(f: in each<Sparse>, g: inout each<Sparse>) { g = g + f; }");
    std::string text = lowering.direct("k");
    // Each structure has its own page table.
    EXPECT_EQ(count(text, "= f_table_data["), 1u) << text;
    EXPECT_EQ(count(text, "= g_table_data["), 1u) << text;
    EXPECT_THAT(text, HasSubstr("if g_found {"));
    EXPECT_THAT(text, Not(HasSubstr("some(")));
}

TEST(Iterators, LoopsOverOffsetsAreUnrolled) {
    Lowering lowering(R"(kernel k(f: in near<Field, 1>, g: out each<Field>) {
        var sum = 0.0;
        for x in -1..2 { sum += f[int3(x, 0, 0)]; }
        g = sum;
    })");
    std::string text = lowering.direct("k");
    EXPECT_THAT(text, Not(HasSubstr("for ")));
    EXPECT_EQ(lowering.forms("k").direct.loop_rounds, 0u);
}

TEST(Iterators, ScatterIsAtomic) {
    Lowering lowering(R"(
translator One : uint -> uint { n: uint; domain() { return n; } translate(va) { return va; } }
structure Bins(n: uint) { memory data = buffer<uint>[n]; via One(n); }
kernel k(f: in each<Field>, h: out scatter<Bins, add>) { h[uint(f * 8.0)] = 1; })");
    std::string text = lowering.direct("k");
    EXPECT_THAT(text, HasSubstr("atomic_add(h_data[h_address], 1u);"));
    EXPECT_THAT(text, HasSubstr("if h_address < $h_n {"));
    EXPECT_THAT(text, HasSubstr("binding h_data: buffer<uint> read_write atomic"));
}

TEST(Iterators, ViewsAreFused) {
    Lowering lowering(R"(
structure Doubled(source: Field) : uint3 -> float { domain() { return source.domain(); } at(p) { return 2.0 * source[p]; } }
kernel k(v: in each<Doubled>, g: out each<Field>) { g = v; })");
    EXPECT_THAT(lowering.direct("k"), HasSubstr("v_source_data["));
}

TEST(Iterators, ReportsOffsets) {
    Lowering lowering(R"(kernel k(f: in near<Field, 1>, g: out each<Field>, d: int) {
        g = f[int3(d, 0, 0)] + f[int3(0, 2, 0)];
    })");
    ASSERT_EQ(lowering.diagnostics.all().size(), 2u);
    EXPECT_EQ(lowering.diagnostics.all()[0].id, Diag::near_offset);
    EXPECT_EQ(lowering.diagnostics.all()[1].id, Diag::near_radius);
    EXPECT_FALSE(lowering.diagnostics.all()[1].notes.empty());
}

TEST(Iterators, UniformValuesAreParameters) {
    Lowering lowering(
        "kernel k(f: in each<Field>, g: out each<Field>, dt: float) { let w = dt / 3.0 - 1.0; g = w * f; }");
    EXPECT_THAT(lowering.direct("k"), HasSubstr("parameter w: float = (dt / 3.0) - 1.0"));
}

TEST(Iterators, ReadsInConditionsStayThere) {
    Lowering lowering(R"(kernel k(a: at<Field>, f: in any<Field>, g: out each<Field>) {
        var x = 0.0;
        if a.x > 3u && f[a + 1u] > 0.5 { x = 1.0; }
        g = x;
    })");
    std::string text = lowering.direct("k");
    EXPECT_LT(text.find("var both"), text.find("f_data[")) << text;
}

TEST(Iterators, FunctionsWithLoopsStayFunctions) {
    Lowering lowering(R"(
fn first(s: Field, x: float) -> uint? {
    for i in 0u..100u { if s[uint3(i, 0u, 0u)] > x { return i; } }
    return none;
}
kernel k(f: in any<Field>, g: out each<Field>, a: at<Field>) { if let i = first(f, float(a.x)) { g = float(i); } })");
    const ir::Pass& pass = lowering.forms("k").direct;
    ASSERT_EQ(pass.functions.size(), 1u);
    EXPECT_EQ(lowering.names[lowering.program.functions[pass.functions[0]].name], "f_first");
    EXPECT_EQ(pass.loop_rounds, 101u);
}

// Loops whose trip count is bounded by a bit count, a remainder, a mask or a shift.
TEST(Iterators, RoundsAreKnownOfLimitsThatHaveABound) {
    Lowering lowering(R"(kernel k(g: out each<Field>, a: at<Field>) {
        var sum = 0.0;
        for i in 0..uint(bitCount(a.x)) { sum += 1.0; }
        for i in 0..a.x % 10u { sum += 1.0; }
        for i in 0..(a.x & 7u) { sum += 1.0; }
        for i in 0..a.x >> 28u { sum += 1.0; }
        g = sum;
    })");
    // The final, failing test of a loop counts as an iteration.
    EXPECT_EQ(lowering.forms("k").direct.loop_rounds, 33u + 10u + 8u + 16u);
}

TEST(Iterators, AWrittenValueIsReadAgain) {
    Lowering lowering("kernel k(f: inout each<Field>) { f = f + 1.0; f = f * 2.0; }");
    EXPECT_EQ(count(lowering.direct("k"), "= f_data[f_at];"), 2u);
}

TEST(Affine, IsInferred) {
    Lowering lowering("kernel k(f: in each<Sparse>, g: in each<Flat>, h: out each<Edged>) { h = f + g; }");
    for (const ir::Translator& translator : lowering.program.translators)
        EXPECT_EQ(translator.properties.affine, lowering.names[translator.name] == "Linear3") << translator.display;
}

}  // namespace
}  // namespace gliftc
