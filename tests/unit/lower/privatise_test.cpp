#include "lowered.h"

#include "ir/walk.h"

#include <gmock/gmock.h>

#include <array>

namespace gliftc {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string structures = R"(
translator Along : uint -> uint { n: uint; domain() { return n; } translate(va) { return va; } }
translator Across : uint2 -> uint {
    extent: uint2;
    domain() { return extent; }
    translate(va) { return va.y * extent.x + va.x; }
}
structure Sums(n: uint) { memory data = buffer<float>[n]; via Along(n); }
structure Counts(n: uint) { memory data = buffer<uint>[n]; via Along(n); }
structure Picture(extent: uint2) { memory data = buffer<float>[extent.x * extent.y]; via Across(extent); }
)";

/// The body that shaders run, and how many elements an invocation takes along each axis.
struct Body {
    std::string text;
    std::array<std::uint32_t, 3> elements;
    bool has_barriers;
};

Body body_of(const std::string& kernel) {
    const Lowering lowering(structures + kernel);
    const ir::Pass& pass = lowering.forms("k").direct;
    const ir::Variant& variant = variant_for(pass, ir::Devices::shaders);
    EXPECT_EQ(variant_for(lowering.forms("k").general, ir::Devices::shaders).assumes.elements,
              variant.assumes.elements);
    return {ir::print(lowering.program, variant.body, &pass), variant.assumes.elements,
            has_any_barrier(lowering.program, variant.body)};
}

constexpr std::array one{1u, 1u, 1u}, along_x{16u, 1u, 1u}, along_y{1u, 64u, 1u};

TEST(Privatise, SumsOfRowsAreTrees) {
    const Body body =
        body_of("kernel k(a: at<Picture>, x: in each<Picture>, to: out scatter<Sums, add>) { to[a.y] = x; }");
    EXPECT_EQ(body.elements, along_x);
    EXPECT_TRUE(body.has_barriers);
    EXPECT_EQ(count(body.text, "atomic_add(to_data["), 1u) << body.text;
    EXPECT_LT(body.text.rfind("barrier()"), body.text.find("atomic_add(")) << body.text;
}

TEST(Privatise, SumsOfColumnsNeedNoBarrier) {
    const Body body =
        body_of("kernel k(a: at<Picture>, x: in each<Picture>, to: out scatter<Sums, add>) { to[a.x] = x; }");
    EXPECT_EQ(body.elements, along_y);
    EXPECT_FALSE(body.has_barriers);
    EXPECT_EQ(count(body.text, "atomic_add(to_data["), 1u) << body.text;
}

/// The condition under which an element of memory exists decides the one update that is left, too.
TEST(Privatise, WhatIsOutsideIsNotUpdated) {
    const Body body =
        body_of("kernel k(a: at<Picture>, x: in each<Picture>, to: out scatter<Sums, add>) { to[a.y] = x; }");
    EXPECT_THAT(body.text.substr(body.text.rfind("barrier()")), HasSubstr("address.y < $to_n")) << body.text;
}

/// A workgroup in which no element meets the condition updates nothing: its address may be outside.
TEST(Privatise, ConditionsOfDataAreRemembered) {
    const Body body = body_of("kernel k(a: at<Picture>, x: in each<Picture>, to: out scatter<Sums, max>) {"
                              "    if x > 0.0 { to[a.y] = x; } }");
    EXPECT_THAT(body.text, HasSubstr("to_data_is_written = true;"));
    EXPECT_THAT(body.text.substr(body.text.rfind("barrier()")), HasSubstr("to_data_is_any[0u] != 0u")) << body.text;
}

TEST(Privatise, AddressesOfDataHaveCopies) {
    const Body body = body_of("kernel k(x: in each<Counts>, to: out scatter<Counts, add>) { to[x] = 1u; }");
    EXPECT_THAT(body.text, HasSubstr("atomicAdd(to_data_copies["));
    EXPECT_EQ(count(body.text, "atomic_add(to_data["), 2u + 7u)
        << body.text;  // of 8 elements without copies, and one of them
}

TEST(Privatise, ElementsThatDifferAreUpdatedAtOnce) {
    for (const char* kernel :
         {"kernel k(a: at<Counts>, x: in each<Counts>, to: out scatter<Counts, add>) { to[a + 3u] = x; }",
          "kernel k(a: at<Picture>, x: in each<Picture>, to: out scatter<Picture, add>) { to[a.yx] = x; }",
          "kernel k(x: in each<Counts>, to: out scatter<Counts>) { to[x] = 1u; }"})
        EXPECT_FALSE(body_of(kernel).has_barriers) << kernel;
}

TEST(Privatise, LoopsAndReturnsAreLeftAlone) {
    EXPECT_EQ(body_of("kernel k(x: in each<Counts>, to: out scatter<Counts, add>) {"
                      "    for i in 0..x { to[0] = i; } }")
                  .elements,
              one);
}

}  // namespace
}  // namespace gliftc
