#include "lowered.h"

#include "ir/validate.h"
#include "ir/walk.h"

#include <gmock/gmock.h>

#include <array>

namespace gliftc {
namespace {

using testing::HasSubstr;

const std::string structures = R"(
struct Large { a: float4; b: float; }
translator Across : uint2 -> uint {
    extent: uint2;
    domain() { return extent; }
    translate(va) { return va.y * extent.x + va.x; }
}
translator Down : uint2 -> uint {
    extent: uint2;
    domain() { return extent; }
    translate(va) { return va.x * extent.y + va.y; }
}
translator Deep : uint3 -> uint {
    extent: uint3;
    domain() { return extent; }
    translate(va) { return (va.z * extent.y + va.y) * extent.x + va.x; }
}
structure Picture(extent: uint2) { memory data = buffer<float>[extent.x * extent.y]; via Across(extent); }
structure Columns(extent: uint2) { memory data = buffer<float>[extent.x * extent.y]; via Down(extent); }
structure Colours(extent: uint2) { memory data = buffer<float4>[extent.x * extent.y]; via Across(extent); }
structure Larges(extent: uint2) { memory data = buffer<Large>[extent.x * extent.y]; via Across(extent); }
structure Volume(extent: uint3) { memory data = buffer<float>[extent.x * extent.y * extent.z]; via Deep(extent); }
)";

/// The body that shaders run on devices that skip branches, its workgroup and how many elements an invocation takes.
struct Body {
    std::string text;
    std::array<std::uint32_t, 3> group, elements;
    std::vector<ir::PassTile> tiles;
};

Body body_of(const std::string& kernel) {
    const Lowering lowering(structures + kernel);
    const ir::Pass &pass = lowering.forms("k").direct, &general = lowering.forms("k").general;
    const ir::Variant& variant = variant_for(pass, ir::Devices::shaders);
    EXPECT_EQ(variant_for(general, ir::Devices::shaders).assumes.elements, variant.assumes.elements);
    EXPECT_EQ(general.group, pass.group);
    EXPECT_EQ(general.tiles, pass.tiles);
    EXPECT_THAT(validate(lowering.program, pass), testing::IsEmpty());
    EXPECT_THAT(validate(lowering.program, general), testing::IsEmpty());
    EXPECT_EQ(has_any_barrier(lowering.program, variant.body), !pass.tiles.empty());
    const std::string text = ir::print(lowering.program, variant.body, &pass);
    const std::string tiled = text.substr(0, text.find("} else {", text.find("if %skips_branches")));
    return {pass.tiles.empty() ? text : tiled, pass.group, variant.assumes.elements, pass.tiles};
}

std::size_t tiles_of(const std::string& kernel) { return body_of("kernel k(" + kernel).tiles.size(); }

constexpr std::array of_xy{32u, 8u, 1u}, of_xz{32u, 1u, 8u}, along_y{1u, 4u, 1u}, along_z{1u, 1u, 4u};

TEST(Tile, StoresBehindABarrier) {
    const Body body =
        body_of("kernel k(a: at<Picture>, x: in each<Picture>, to: out scatter<Picture>) { to[a.yx] = x; }");
    EXPECT_EQ(body.group, of_xy);
    EXPECT_EQ(body.elements, along_y);
    ASSERT_EQ(body.tiles.size(), 1u);
    EXPECT_TRUE(body.tiles[0].is_store);
    const std::size_t barrier = body.text.find("barrier()");
    EXPECT_LT(body.text.rfind("= x_data["), barrier) << body.text;
    EXPECT_GT(body.text.find("to_data["), barrier) << body.text;
    EXPECT_EQ(count(body.text, " to_data["), 4u) << body.text;
}

/// A store under a condition of the source may be rare: its value is not computed for all elements.
TEST(Tile, ConditionsOfAddressesAreAskedTwice) {
    const Body body = body_of("kernel k(a: at<Picture>, x: in each<Picture>, to: out scatter<Picture>) "
                              "{ if a.x < 7u { to[a.yx] = x; } }");
    EXPECT_EQ(body.tiles.size(), 1u);
    EXPECT_THAT(body.text, testing::Not(HasSubstr("is_written"))) << body.text;
    EXPECT_EQ(count(body.text, ".x < 7u"), 8u) << body.text;
    EXPECT_GT(body.text.find("= x_data["), body.text.find(".x < 7u")) << body.text;
}

TEST(Tile, LoadsBeforeABarrier) {
    const Body body = body_of("kernel k(a: at<Picture>, x: in any<Picture>, to: out each<Picture>) { to = x[a.yx]; }");
    ASSERT_EQ(body.tiles.size(), 1u);
    EXPECT_FALSE(body.tiles[0].is_store);
    const std::size_t barrier = body.text.find("barrier()");
    EXPECT_LT(body.text.rfind("x_data["), barrier) << body.text;
    EXPECT_GT(body.text.find(" to_data["), barrier) << body.text;
}

TEST(Tile, AxesOfVolumes) {
    const std::string parameters = "kernel k(a: at<Volume>, x: in each<Volume>, to: out scatter<Volume>) ";
    for (const char* address : {"a.zyx", "a.zxy"}) {
        const Body body = body_of(parameters + "{ to[" + address + "] = x; }");
        EXPECT_EQ(body.group, of_xz) << address;
        EXPECT_EQ(body.elements, along_z) << address;
    }
    for (const char* address : {"a.yxz", "a.yzx"})
        EXPECT_EQ(body_of(parameters + "{ to[" + address + "] = x; }").group, of_xy);
    EXPECT_TRUE(body_of(parameters + "{ to[a.xzy] = x; }").tiles.empty());
}

/// A condition that loads is asked once, and its result is kept beside the value.
TEST(Tile, ConditionsOfElements) {
    const Body body = body_of("kernel k(a: at<Picture>, x: in each<Picture>, to: out scatter<Picture>) "
                              "{ if x > 1.0 { to[a.yx] = x; } }");
    EXPECT_EQ(body.tiles.size(), 1u);
    EXPECT_THAT(body.text, HasSubstr("to_data_is_written[")) << body.text;
}

TEST(Tile, WhatLiesInMemoryAsItIsVisitedHasNone) {
    EXPECT_EQ(tiles_of("a: at<Picture>, x: in each<Picture>, to: out scatter<Picture>) { to[a] = x; }"), 0u);
    EXPECT_EQ(tiles_of("a: at<Picture>, x: in any<Picture>, to: out each<Picture>) { to = x[a + 1u]; }"), 0u);
}

TEST(Tile, MemoryInColumns) {
    EXPECT_EQ(tiles_of("x: in each<Picture>, to: out each<Columns>) { to = x; }"), 1u);
    EXPECT_EQ(tiles_of("x: in each<Columns>, to: out each<Picture>) { to = x; }"), 1u);
    // Both may be one memory.
    EXPECT_EQ(tiles_of("x: in each<Columns>, to: out each<Columns>) { to = x; }"), 0u);
}

TEST(Tile, OrderOfStoresIsKept) {
    EXPECT_EQ(tiles_of("a: at<Picture>, x: in each<Picture>, to: out scatter<Picture>) "
                       "{ to[a.yx] = x; to[a.yx] = 1.0; }"),
              0u);
}

TEST(Tile, LargeElementsHaveNone) {
    EXPECT_EQ(tiles_of("a: at<Colours>, x: in each<Colours>, to: out scatter<Colours>) { to[a.yx] = x; }"), 1u);
    EXPECT_EQ(tiles_of("a: at<Larges>, x: in each<Larges>, to: out scatter<Larges>) { to[a.yx] = x; }"), 0u);
}

/// Two tiles of 16 bytes an element are more workgroup memory than every device has.
TEST(Tile, WorkgroupMemoryIsLimited) {
    EXPECT_EQ(tiles_of("a: at<Colours>, x: in each<Colours>, to: out scatter<Colours>, more: out scatter<Colours>) "
                       "{ to[a.yx] = x; more[a.yx] = x; }"),
              1u);
}

TEST(Tile, LoopsHaveNone) {
    EXPECT_EQ(tiles_of("a: at<Picture>, x: in each<Picture>, n: uint, to: out scatter<Picture>) "
                       "{ var s = x; for i in 0u..n { s = s * 2.0; } to[a.yx] = s; }"),
              0u);
}

}  // namespace
}  // namespace gliftc
