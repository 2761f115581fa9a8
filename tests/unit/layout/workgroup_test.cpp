// Which workgroup arrays (`shared`) share memory with each other.
#include "../lower/lowered.h"
#include "layout/layout.h"

namespace gliftc {
namespace {

/// How the workgroup arrays of kernel `k` are allocated, with the total bytes: `a+b c` if a and b share memory.
std::string places(const std::string& kernel) {
    Lowering module(R"(
structure Line(extent: uint3) {
    memory data = buffer<float>[extent.x * extent.y * extent.z];
    via Linear3(extent);
}
)" + kernel);
    layout::lay_out(module.program, module.lowered);
    const ir::Pass& pass = module.forms("k").direct;
    std::string text;
    for (const std::vector<ir::LocalId>& place : pass.shared_places) {
        if (!text.empty()) text += " ";
        for (std::size_t i = 0; i < place.size(); ++i)
            text += (i ? "+" : "") + std::string(module.names[module.program.locals[place[i]].name]);
    }
    return text + ", " + std::to_string(pass.shared_bytes);
}

TEST(WorkgroupMemory, ArraysWhoseLifetimesABarrierPartsTakeOnePlace) {
    EXPECT_EQ(places(R"(
kernel k(x: in each<Line>, to: out each<Line>) group(8) {
    shared a: float[8];
    shared b: float[16];
    a[local_index()] = x;
    barrier();
    let y = a[7u - local_index()];
    barrier();
    b[local_index()] = y;
    barrier();
    to = b[local_index() / 2u];
}
)"),
              "a+b, 64");
}

TEST(WorkgroupMemory, WithoutABarrierBetweenThemTheyDoNot) {
    EXPECT_EQ(places(R"(
kernel k(x: in each<Line>, to: out each<Line>) group(8) {
    shared a: float[8];
    shared b: float[8];
    a[local_index()] = x;
    barrier();
    b[local_index()] = a[7u - local_index()];
    barrier();
    to = b[local_index() / 2u];
}
)"),
              "a b, 64");
}

TEST(WorkgroupMemory, ABarrierInALoopPartsNothing) {
    EXPECT_EQ(places(R"(
kernel k(x: in each<Line>, to: out each<Line>) group(8) {
    shared a: float[8];
    shared b: float[8];
    var sum = 0.0;
    for i in 0..3 {
        a[local_index()] = x;
        barrier();
        sum += a[7u - local_index()];
        barrier();
        b[local_index()] = sum;
        barrier();
        sum += b[local_index() / 2u];
        barrier();
    }
    to = sum;
}
)"),
              "a b, 64");
}

TEST(WorkgroupMemory, OtherElementsHaveAnotherPlace) {
    EXPECT_EQ(places(R"(
kernel k(x: in each<Line>, to: out each<Line>) group(8) {
    shared a: float[8];
    shared b: uint[8];
    shared c: float[4];
    a[local_index()] = x;
    barrier();
    let y = a[7u - local_index()];
    barrier();
    b[local_index()] = uint(y);
    barrier();
    c[local_index() / 2u] = float(b[local_index() / 2u]);
    barrier();
    to = c[local_index() / 2u];
}
)"),
              "a+c b, 64");
}

TEST(WorkgroupMemory, WhatAFunctionSharesCountsAtEachCall) {
    EXPECT_EQ(places(R"(
fn turned<G: uint>(x: float) group(G) -> float {
    shared all: float[G];
    barrier();
    all[local_index()] = x;
    barrier();
    return all[G - 1u - local_index()];
}
kernel k(x: in each<Line>, to: out each<Line>) group(8) {
    shared a: float[8];
    let y = turned(x);
    a[local_index()] = y;
    barrier();
    let z = turned(a[local_index() / 2u]);
    to = z;
}
)"),
              "all a, 64");
}

}  // namespace
}  // namespace gliftc
