// Compares reductions and scans, most of them of types other than 32-bit scalars, with the C++ library's and with
// plain loops.
#include "input.h"

#include "types.glift.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

using namespace property;
using forms::Part;
using types::Line;
using types::Matrix;
using Longs = Input<types::Longs, types::Longs, types::TiledLongs, Line>;
using Doubles = Input<types::Doubles, types::Doubles, types::Doubles, Line>;
using Pairs = Input<types::Pairs, types::FoldedPairs, types::TiledPairs, Line>;
using Colours = Input<types::Colours, types::Colours, types::Colours, Line>;

GLIFT_PROPERTY_SUITE(Types);

Matrix product(const Matrix& x, const Matrix& y) {
    return {x.a * y.a + x.b * y.c, x.a * y.b + x.b * y.d, x.c * y.a + x.d * y.c, x.c * y.b + x.d * y.d};
}

std::int64_t wrapping_sum(std::int64_t a, std::int64_t b) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
}

/// n u / (1 - n u), u = 2^-24: the error of a sum of n floats, grouped in any way, is at most this times the sum of the
/// absolute values (Higham, Accuracy and Stability of Numerical Algorithms, 4.2).
double relative_bound(double n) {
    const double nu = n * 0x1p-24;
    return nu < 0.5 ? nu / (1 - nu) : INFINITY;
}

std::vector<float> component(const std::vector<glift::float3>& values, unsigned k) {
    std::vector<float> found;
    for (const glift::float3& value : values) found.push_back(value[k]);
    return found;
}

TEST_P(Types, SumOfLongs) {
    for_all("reduce, sum of int64", [&](Round& round) {
        round.only(Form::strided);
        const Placed placed(round, round.size());
        const auto values = arbitrary_values<std::int64_t>(round, placed.count);
        const Longs in(device(), round, placed, values);
        types::Longs to(device(), 1);
        const auto found = twice(round, [&] {
            to.fill(77);
            types::sum_of_longs(device(), in.dense, in.step, placed.part<Part>(), in.length, to);
            return to.read();
        });
        const auto sum = std::accumulate(values.begin(), values.end(), std::int64_t{0}, wrapping_sum);
        EXPECT_TRUE(equal(round, {sum}, found));
    });
}

/// Multiples of 2^-30 from -1 to 1. Sums of a million of them are exact in double precision, in any order, but not in
/// single precision.
std::vector<double> fractions(Round& round, std::uint32_t count) {
    std::vector<double> values(count);
    for (double& x : values) x = std::round(round.real() * 0x1p30) * 0x1p-30;
    return values;
}

TEST_P(Types, ReductionsOfDoubles) {
    if (!device().properties().float64) GTEST_SKIP() << "no 64-bit floats";
    for_all("reduce, sum, smallest and largest of doubles", [&](Round& round) {
        round.only(Form::dense);
        const Placed placed(round, round.size());
        const auto values = fractions(round, placed.count);
        const Doubles in(device(), round, placed, values);
        types::Doubles to(device(), 3);
        const auto found = twice(round, [&] {
            to.fill(77);
            types::reduce_doubles(device(), in.dense, placed.part<Part>(), in.length, to);
            return to.read();
        });
        constexpr double none = std::numeric_limits<double>::infinity();
        std::vector<double> expected{0, none, -none};
        for (double x : values) expected = {expected[0] + x, std::min(expected[1], x), std::max(expected[2], x)};
        EXPECT_TRUE(equal(round, expected, found));
    });
}

TEST_P(Types, ScanOfDoubles) {
    if (!device().properties().float64) GTEST_SKIP() << "no 64-bit floats";
    for_all("inclusive_scan, sums of doubles", [&](Round& round) {
        round.only(Form::dense);
        const Placed placed(round, round.size());
        auto values = fractions(round, placed.count);
        const Doubles in(device(), round, placed, values);
        Output<types::Doubles> out(device(), round, placed);
        const auto found = twice(round, [&] {
            return out.after([&](const types::Doubles& to) {
                types::scan_doubles(device(), in.dense, placed.part<Part>(), in.length, to);
            });
        });
        std::inclusive_scan(values.begin(), values.end(), values.begin());
        EXPECT_TRUE(equal(round, out.expected(placed, values), found));
    });
}

TEST_P(Types, SumOfColours) {
    for_all("reduce, sum of float3", [&](Round& round) {
        round.only(Form::mapped);
        const Placed placed(round, round.size());
        const auto values = arbitrary_values<glift::float3>(round, placed.count);
        const Colours in(device(), round, placed, values);
        types::Colours to(device(), 1);
        const auto found = twice(round, [&] {
            to.fill({77, 77, 77});
            types::sum_of_colours(device(), in.dense, placed.part<Part>(), in.length, to);
            return to.read();
        });
        for (unsigned k = 0; k < 3; ++k) {
            double sum = 0, sizes = 0;
            for (const glift::float3& x : values) sum += x[k], sizes += std::abs(x[k]);
            EXPECT_TRUE(near(round, {sum}, {sizes * relative_bound(placed.count)}, component(found, k)));
        }
    });
}

TEST_P(Types, LargestOfPairs) {
    for_all("maximum of uint2", [&](Round& round) {
        round.only(Form::folded);
        const Placed placed(round, round.size());
        const auto values = arbitrary_values<glift::uint2>(round, placed.count);
        const Pairs in(device(), round, placed, values);
        const auto found = types::largest(device(), in.folded, placed.part<Part>(), in.length).await(device());
        glift::uint2 most;
        for (const glift::uint2& x : values) most = {std::max(most.x, x.x), std::max(most.y, x.y)};
        EXPECT_TRUE(equal(round, {most}, std::vector<glift::uint2>{found}));
    });
}

TEST_P(Types, ProductOfMatrices) {
    using In = Input<Line, types::Folded, Line, Line>;
    for_all("transform_reduce, product of matrices", [&](Round& round) {
        round.only(Form::folded);
        const Placed placed(round, round.size());
        const auto values = arbitrary_values<std::uint32_t>(round, placed.count);
        const In in(device(), round, placed, values);
        const auto found = types::product(device(), in.folded, placed.part<Part>(), in.length).await(device());
        Matrix expected{1, 0, 0, 1};
        for (std::uint32_t x : values) expected = product(expected, {1, x & 65535, x >> 16, 1});
        EXPECT_TRUE(equal(round, {expected}, std::vector<Matrix>{found}));
    });
}

TEST_P(Types, InnerProductOfPairs) {
    for_all("inner_product of uint2, of tiles and a view", [&](Round& round) {
        round.only(Form::tiled);
        const Placed placed(round, round.size());
        const auto values = arbitrary_values<glift::uint2>(round, placed.count);
        const auto others = arbitrary_values<glift::uint2>(round, placed.extent);
        const Pairs in(device(), round, placed, values);
        types::Pairs b(device(), placed.extent);
        b.write(others);
        const auto found = types::inner_pairs(device(), in.tiled, placed.part<Part>(), in.length, b).await(device());
        glift::uint2 expected;
        for (std::uint32_t i = 0; i < placed.count; ++i) expected += values[i] * ~others[placed.first + i];
        EXPECT_TRUE(equal(round, {expected}, std::vector<glift::uint2>{found}));
    });
}

TEST_P(Types, TheFirstOfTheLargest) {
    using In = Input<types::Integers, types::FoldedIntegers, types::Integers, Line>;
    for_all("max_element of ints, many of them equal", [&](Round& round) {
        round.only(Form::folded);
        const Placed placed(round, round.size());
        const auto values = values_with_repeats<std::int32_t>(round, placed.count);
        const In in(device(), round, placed, values);
        const auto found = types::first_largest(device(), in.folded, placed.part<Part>(), in.length).await(device());
        std_min_element::Element_int expected{.value = INT32_MIN, .index = UINT32_MAX};
        const auto at = std::ranges::max_element(values);
        if (at != values.end()) expected = {*at, static_cast<std::uint32_t>(at - values.begin())};
        EXPECT_TRUE(equal(round, {expected}, std::vector<std_min_element::Element_int>{found}));
    });
}

TEST_P(Types, ScanOfLongs) {
    for_all("inclusive_scan, sums of int64", [&](Round& round) {
        round.only(Form::tiled);
        const Placed placed(round, round.size());
        auto values = arbitrary_values<std::int64_t>(round, placed.count);
        const Longs in(device(), round, placed, values);
        Output<types::Longs> out(device(), round, placed);
        const auto found = twice(round, [&] {
            return out.after([&](const types::Longs& to) {
                types::scan_longs(device(), in.tiled, placed.part<Part>(), in.length, to);
            });
        });
        std::inclusive_scan(values.begin(), values.end(), values.begin(), wrapping_sum);
        EXPECT_TRUE(equal(round, out.expected(placed, values), found));
    });
}

TEST_P(Types, ScanOfColours) {
    for_all("exclusive_scan, sums of float3", [&](Round& round) {
        round.only(Form::strided);
        const Placed placed(round, round.size());
        const auto values = arbitrary_values<glift::float3>(round, placed.count);
        const Colours in(device(), round, placed, values);
        Output<types::Colours> out(device(), round, placed);
        const auto found = twice(round, [&] {
            return out.after([&](const types::Colours& to) {
                types::scan_colours(device(), in.dense, in.step, placed.part<Part>(), in.length, to);
            });
        });
        for (unsigned k = 0; k < 3; ++k) {
            const auto before = component(out.before, k);
            std::vector<double> expected(before.begin(), before.end()), bounds(placed.extent);
            double sum = 0, sizes = 0;
            for (std::uint32_t i = 0; i < placed.count; ++i) {
                expected[placed.first + i] = sum;
                bounds[placed.first + i] = sizes * relative_bound(i);
                sum += values[i][k];
                sizes += std::abs(values[i][k]);
            }
            EXPECT_TRUE(near(round, expected, bounds, component(found, k)));
        }
    });
}

}  // namespace
