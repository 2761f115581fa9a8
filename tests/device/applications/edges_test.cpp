// Tests the rules by which coverage is compared between devices (edges.h): `rounded` excuses differences near edges,
// `exact` only those near edges of clipped triangles; neither excuses any other.
#include "edges.h"

#include <gtest/gtest.h>

namespace {

using edges::Rule;
using glift::float4;
using glift::uint2;

constexpr uint2 size(8, 8);

/// A triangle from y = 1 to 7 whose left edge is vertical, `beside` pixels left of the centres of column 3.
std::vector<float4> triangle(double beside) {
    const auto at = [](double x, double y, float w) {
        return float4(static_cast<float>(x / 4 - 1) * w, static_cast<float>(y / 4 - 1) * w, 0.5f * w, w);
    };
    return {at(3.5 - beside, 1, 1), at(3.5 - beside, 7, 2), at(7, 4, 0.5f)};
}

/// The number of pixels that the rule does not excuse if one device has `more` more triangles at a pixel.
std::size_t unexplained(const std::vector<float4>& places, uint2 pixel, Rule rule, std::uint32_t more = 1) {
    const std::vector<std::uint32_t> a(size.x * size.y, 5);
    std::vector<std::uint32_t> b = a;
    b[pixel.y * size.x + pixel.x] += more;
    const edges::Difference found = edges::compared(a, b, places, size, rule);
    EXPECT_EQ(found.pixels, 1u);
    EXPECT_EQ(edges::compared(b, a, places, size, rule).unexplained.size(), found.unexplained.size());
    return found.unexplained.size();
}

TEST(Edges, ExplainACentreWithinA256thOfAPixel) {
    for (const double beside : {0.0, 0.5 / 256, -0.9 / 256})
        EXPECT_EQ(unexplained(triangle(beside), {3, 4}, Rule::rounded), 0u) << beside;
    for (const double beside : {1.1 / 256, -1.1 / 256, 0.25, -3.0})
        EXPECT_EQ(unexplained(triangle(beside), {3, 4}, Rule::rounded), 1u) << beside;
}

TEST(Edges, ExplainNothingOfWholeTrianglesWhereRoundingIsTheSame) {
    for (const double beside : {0.0, 0.5 / 256, 0.25})
        EXPECT_EQ(unexplained(triangle(beside), {3, 4}, Rule::exact), 1u) << beside;
}

TEST(Edges, EndAtTheCorners) {
    EXPECT_EQ(unexplained(triangle(0), {3, 1}, Rule::rounded), 0u);
    EXPECT_EQ(unexplained(triangle(0), {3, 0}, Rule::rounded), 1u) << "on the edge's line, beyond its end";
    EXPECT_EQ(unexplained(triangle(0), {3, 7}, Rule::rounded), 1u);
}

TEST(Edges, ExplainOneTriangleEach) {
    std::vector<float4> two = triangle(0);
    EXPECT_EQ(unexplained(two, {3, 4}, Rule::rounded, 2), 1u);
    const std::vector<float4> other = triangle(0.5 / 256);
    two.insert(two.end(), other.begin(), other.end());
    EXPECT_EQ(unexplained(two, {3, 4}, Rule::rounded, 2), 0u);
}

TEST(Edges, OfClippedTrianglesMayMove) {
    std::vector<float4> clipped = triangle(1.2 / 256);
    clipped[2] = float4(3, 0, 0.5f, 1);  // beyond the window
    EXPECT_EQ(unexplained(clipped, {3, 4}, Rule::exact), 0u);
    clipped = triangle(2.0 / 256);
    clipped[2] = float4(3, 0, 0.5f, 1);
    EXPECT_EQ(unexplained(clipped, {3, 4}, Rule::exact), 1u);
}

TEST(Edges, OfNothingExplainNothing) { EXPECT_EQ(unexplained({}, {3, 4}, Rule::rounded), 1u); }

}  // namespace
