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

constexpr std::array one{1u, 1u, 1u}, along_x{16u, 1u, 1u}, of_rows{16u, 4u, 1u}, along_y{1u, 64u, 1u};

TEST(Privatise, SumsOfRowsAreTrees) {
    const Body body =
        body_of("kernel k(a: at<Picture>, x: in each<Picture>, to: out scatter<Sums, add>) { to[a.y] = x; }");
    EXPECT_EQ(body.elements, of_rows);
    EXPECT_TRUE(body.has_barriers);
    EXPECT_EQ(count(body.text, "atomic_add(to_data["), 1u) << body.text;
    EXPECT_LT(body.text.rfind("barrier()"), body.text.find("atomic_add(")) << body.text;
}

TEST(Privatise, SumsOfColumnsNeedNoBarrier) {
    const Body body =
        body_of("kernel k(a: at<Picture>, x: in each<Picture>, to: out scatter<Counts, add>) { to[a.x] = uint(x); }");
    EXPECT_EQ(body.elements, along_y);
    EXPECT_FALSE(body.has_barriers);
    EXPECT_EQ(count(body.text, "atomic_add(to_data["), 1u) << body.text;
}

/// The parts of sums of floats meet in a memory, and one invocation updates the element.
TEST(Privatise, SumsOfFloatsHaveAnOrder) {
    for (const std::string place : {"0u", "a.y", "a.x"}) {
        const std::string kernel =
            "kernel k(a: at<Picture>, x: in each<Picture>, to: out scatter<Sums, add>) { to[" + place + "] = x; }";
        const Lowering lowering(structures + kernel);
        for (const ir::Pass* pass : lowering.forms("k").all()) {
            const std::string text = ir::print(lowering.program, variant_for(*pass, ir::Devices::shaders).body, pass);
            EXPECT_EQ(count(text, "atomicAdd(partial_sums["), 1u) << text;
            EXPECT_EQ(count(text, "atomic_add(to_data["), 1u) << text;
            EXPECT_EQ(pass->sum_orders().size(), 1u);
            EXPECT_TRUE(pass->exact) << kernel;
        }
    }
}

/// Two updates of one buffer, and updates of which elements along x have different addresses, have none.
TEST(Privatise, OtherSumsOfFloatsHaveNoOrder) {
    for (const std::string statements : {"to[0] = x; to[a.y] = x;", "to[a.x + a.y] = x;", "to[uint(x)] = x;"}) {
        const Lowering lowering(structures +
                                "kernel k(a: at<Picture>, x: in each<Picture>, to: out scatter<Sums, add>) { " +
                                statements + " }");
        EXPECT_TRUE(lowering.forms("k").direct.sum_orders().empty()) << statements;
        EXPECT_FALSE(lowering.forms("k").direct.exact) << statements;
    }
}

/// Sums of different rows that are of one element: the rows have an order each, the two additions have none.
TEST(Privatise, SumsOfOneElementAreNotExact) {
    const Lowering lowering(
        structures + "kernel k(a: at<Picture>, x: in each<Picture>, to: out scatter<Sums, add>) { to[a.y / 2u] = x; }");
    EXPECT_EQ(lowering.forms("k").direct.sum_orders().size(), 1u);
    EXPECT_FALSE(lowering.forms("k").direct.exact);
}

/// Where no element of a workgroup is written, because the address is outside or no element meets a condition, nothing
/// is updated.
TEST(Privatise, WhatIsNotWrittenIsNotUpdated) {
    const auto update_of = [](const std::string& kernel) {
        const std::string text = body_of(kernel).text;
        return text.substr(text.rfind("if ", text.rfind("atomic_")));
    };
    EXPECT_THAT(update_of("kernel k(a: at<Picture>, x: in each<Picture>, to: out scatter<Sums, add>) { to[a.y] = x; }"),
                HasSubstr(" != 2147483648u)"));
    EXPECT_THAT(update_of("kernel k(a: at<Picture>, x: in each<Picture>, to: out scatter<Sums, max>) {"
                          "    if x > 0.0 { to[a.y] = x; } }"),
                HasSubstr(" != -2147483648)"));
}

/// The value of an update under an if is computed outside of it where that is possible, with what the if declares.
TEST(Privatise, ValuesAreOutsideOfIfs) {
    const Body body = body_of("kernel k(a: at<Picture>, x: in each<Picture>, n: uint, to: out scatter<Sums, add>) {"
                              "    if a.y < n { let t = x * 2.0; to[a.y] = t * t; } }");
    EXPECT_EQ(body.elements, of_rows);
    const Body of_variable =
        body_of("kernel k(a: at<Picture>, x: in each<Picture>, n: uint, to: out scatter<Sums, add>) {"
                "    var t = x; if a.y < n { t = t * 2.0; to[a.y] = t + 1.0; } }");
    EXPECT_EQ(of_variable.elements, of_rows);
    EXPECT_EQ(count(of_variable.text, "to_data_value"), 0u) << of_variable.text;
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

TEST(Privatise, KernelsWithLoopsHaveTreesOfOneElement) {
    const Body in_loop = body_of("kernel k(x: in each<Counts>, to: out scatter<Counts, add>) {"
                                 "    for i in 0..x { to[0] = i; } }");
    EXPECT_EQ(in_loop.elements, one);
    EXPECT_EQ(count(in_loop.text, "atomic_add(to_data["), 1u) << in_loop.text;
    const Body after = body_of("kernel k(x: in each<Counts>, to: out scatter<Counts, add>) {"
                               "    var n = 0u; for i in 0..x { n += i * i; } to[n] = 1u; }");
    EXPECT_EQ(after.elements, one);
    EXPECT_THAT(after.text, HasSubstr("atomicAdd(to_data_copies["));
    const Body data_in_loop = body_of("kernel k(x: in each<Counts>, to: out scatter<Counts, add>) {"
                                      "    for i in 0..x { to[x + i] = i; } }");
    EXPECT_THAT(data_in_loop.text, Not(HasSubstr("to_data_copies")));
}

TEST(Privatise, NeighboursOfOneAddressAreRuns) {
    for (const auto& [address, elements] :
         {std::pair("a / 4u", 4u), std::pair("a / 40u + 3u", 8u), std::pair("a >> 5u", 16u)}) {
        const Body body = body_of("kernel k(a: at<Counts>, x: in each<Counts>, to: out scatter<Counts, add>) { to[" +
                                  std::string(address) + "] = x; }");
        EXPECT_EQ(body.elements, (std::array{elements, 1u, 1u})) << address;
        EXPECT_FALSE(body.has_barriers) << address;
    }
    EXPECT_THAT(
        body_of("kernel k(a: at<Counts>, x: in each<Counts>, to: out scatter<Counts, add>) { to[a / 3u] = x; }").text,
        HasSubstr("to_data_copies"));
}

TEST(Privatise, SumsOfOneOrderShareATree) {
    const Body body =
        body_of("kernel k(x: in each<Sums>, all: out scatter<Sums, add>, squares: out scatter<Sums, add>) {"
                "    all[0] = x; squares[0] = x * x; }");
    EXPECT_EQ(count(body.text, "atomicAdd(partial_sums["), 1u) << body.text;
}

TEST(Privatise, FastMathIsNotExact) {
    const std::string kernel = "kernel k(x: in each<Sums>, to: out each<Sums>) { to = x / (x + 1.0); }";
    EXPECT_TRUE(Lowering(structures + kernel).forms("k").direct.exact);
    EXPECT_FALSE(Lowering(structures + "@fast_math " + kernel).forms("k").direct.exact);
}

TEST(Privatise, ReturnsAreLeftAlone) {
    EXPECT_EQ(body_of("kernel k(x: in each<Counts>, to: out scatter<Counts, add>) {"
                      "    if x > 3u { return; } to[0] = x; }")
                  .elements,
              one);
}

}  // namespace
}  // namespace gliftc
