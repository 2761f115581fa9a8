// Compares reductions with std::accumulate, std::inner_product, std::find and others, and with plain loops.
#include "input.h"

#include "reductions.glift.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

using namespace property;
using forms::Part;
using reductions::Affine;
using Uints = Input<reductions::Line, reductions::Folded, reductions::Tiles, reductions::Line>;
using Floats = Input<reductions::Reals, reductions::TiledReals, reductions::TiledReals, reductions::Line>;

GLIFT_PROPERTY_SUITE(Reductions);

/// A bound on the error of a sum of n floats, grouped in any way, given the sum of their absolute values. It is at most
/// (n - 1) u / (1 - (n - 1) u) times that sum, u = 2^-24 (Higham, Accuracy and Stability of Numerical Algorithms, 4.2);
/// n in place of n - 1 holds for sums of rounded products, too.
double bound_of(double sum_of_sizes, double n) {
    const double nu = n * 0x1p-24;
    return nu < 0.5 ? sum_of_sizes * nu / (1 - nu) : std::numeric_limits<double>::infinity();
}

/// Either small whole numbers, whose sums are exact in any order; or numbers of very different sizes.
std::vector<float> float_values(Round& round, std::uint32_t size) {
    std::vector<float> values(size);
    const bool exact = round.chance(2);
    for (float& x : values) x = exact ? float(round.below(17)) - 8 : float(round.real() * std::exp2(round.real() * 10));
    return values;
}

TEST_P(Reductions, SumOfUints) {
    for_all("reduce, sum of uints", [&](Round& round) {
        const Placed placed(round, round.size());
        const auto values = arbitrary_values<std::uint32_t>(round, placed.count);
        const Uints in(device(), round, placed, values);
        reductions::Line to(device(), 1);
        const auto found = twice(round, [&] {
            to.fill(77);
            reductions::sum_of_uints(device(), in.form, in.dense, in.folded, in.tiled, in.step, placed.part<Part>(),
                                     in.length, to);
            return to.read();
        });
        EXPECT_TRUE(equal(round, {std::accumulate(values.begin(), values.end(), 0u)}, found));
    });
}

TEST_P(Reductions, SumOfFloats) {
    for_all("reduce, sum of floats", [&](Round& round) {
        round.only(round.form() == Form::tiled ? Form::tiled : Form::dense);
        const Placed placed(round, round.size());
        const std::vector<float> values = float_values(round, placed.count);
        const Floats in(device(), round, placed, values);
        reductions::Reals to(device(), 1);
        const auto found = twice(round, [&] {
            to.fill(77);
            reductions::sum_of_floats(device(), in.form, in.dense, in.tiled, placed.part<Part>(), in.length, to);
            return to.read();
        });
        double sum = 0, sizes = 0;
        for (float x : values) sum += x, sizes += std::abs(x);
        const bool whole_numbers = std::ranges::all_of(values, [](float x) { return x == std::floor(x); });
        const double bound = whole_numbers && sizes < 0x1p24 ? 0 : bound_of(sizes, placed.count);
        EXPECT_TRUE(near(round, {sum}, {bound}, found));
    });
}

TEST_P(Reductions, AnOperatorThatDoesNotCommute) {
    for_all("reduce, composition", [&](Round& round) {
        round.only(Form::dense);
        const Placed placed(round, round.size());
        std::vector<Affine> all(placed.extent);
        for (Affine& f : all) f = {arbitrary<std::uint32_t>(round), arbitrary<std::uint32_t>(round)};
        const reductions::Maps from(device(), placed.extent), to(device(), 1);
        reductions::Maps(from).write(all);
        reductions::Line length(device(), 1);
        length.write(std::vector<glift::uint>{placed.count});
        Affine sum = {1, 0};
        for (std::uint32_t i = 0; i < placed.count; ++i) {
            const Affine g = all[placed.first + i];
            sum = {sum.scale * g.scale, g.scale * sum.offset + g.offset};
        }
        reductions::composition(device(), from, placed.part<Part>(), length, to);
        EXPECT_TRUE(equal(round, {sum}, to.read()));
    });
}

TEST_P(Reductions, SumAndExtremesOfInts) {
    for_all("reduce, of ints", [&](Round& round) {
        round.only(Form::dense);
        const Placed placed(round, round.size());
        const auto all = arbitrary_values<std::int32_t>(round, placed.extent);
        reductions::Integers from(device(), placed.extent), to(device(), 3);
        from.write(all);
        reductions::Line length(device(), 1);
        length.write(std::vector<glift::uint>{placed.count});
        std::uint32_t sum = 0;
        std::int32_t least = INT32_MAX, most = INT32_MIN;
        for (std::uint32_t i = 0; i < placed.count; ++i) {
            const std::int32_t x = all[placed.first + i];
            sum += static_cast<std::uint32_t>(x);
            least = std::min(least, x);
            most = std::max(most, x);
        }
        reductions::of_ints(device(), from, placed.part<Part>(), length, to);
        EXPECT_TRUE(equal(round, {static_cast<std::int32_t>(sum), least, most}, to.read()));
    });
}

TEST_P(Reductions, HowMany) {
    for_all("count_if", [&](Round& round) {
        round.only(Form::tiled);
        const Placed placed(round, round.size());
        const auto values = arbitrary_values<std::uint32_t>(round, placed.count);
        const Uints in(device(), round, placed, values);
        const std::uint32_t limit = round.chance(5) ? 0 : arbitrary<std::uint32_t>(round);
        const auto found =
            reductions::how_many(device(), in.tiled, placed.part<Part>(), in.length, limit).await(device());
        const auto count = std::ranges::count_if(values, [&](std::uint32_t x) { return x < limit; });
        EXPECT_TRUE(equal(round, {static_cast<std::uint32_t>(count)}, std::vector<std::uint32_t>{found}));
    });
}

TEST_P(Reductions, Find) {
    for_all("find", [&](Round& round) {
        round.only(Form::folded);
        const Placed placed(round, round.size());
        std::vector<std::uint32_t> values(placed.count);
        const std::uint32_t kinds = 1 + round.below(2 * std::uint64_t{placed.count} + 1);
        for (auto& x : values) x = round.below(kinds);
        const std::uint32_t value = round.below(kinds);
        const Uints in(device(), round, placed, values);
        const auto found =
            reductions::where_is(device(), in.folded, placed.part<Part>(), in.length, value).await(device());
        const auto at = std::find(values.begin(), values.end(), value) - values.begin();
        EXPECT_TRUE(equal(round, {static_cast<std::uint32_t>(at)}, std::vector<std::uint32_t>{found}));
    });
}

TEST_P(Reductions, WhereTheExtremesAre) {
    for_all("min_element and max_element", [&](Round& round) {
        round.only(Form::mapped);
        const Placed placed(round, round.size());
        std::vector<float> values = float_values(round, placed.count);
        for (float& x : values)
            if (round.chance(20)) x = NAN;
        const Floats in(device(), round, placed, values);
        const bool largest = round.chance(2);
        const auto found =
            reductions::extreme(device(), in.dense, placed.part<Part>(), in.length, largest).await(device());
        std_min_element::Element_float expected{.value = largest ? -INFINITY : INFINITY, .index = UINT32_MAX};
        for (std::uint32_t i = 0; i < placed.count; ++i)
            if (largest ? values[i] > expected.value : values[i] < expected.value) expected = {values[i], i};
        EXPECT_TRUE(equal(round, {expected.index}, std::vector<std::uint32_t>{found.index}, "index:"));
        EXPECT_EQ(found.value, expected.value);
    });
}

TEST_P(Reductions, InnerProductOfUints) {
    for_all("inner_product of uints", [&](Round& round) {
        round.only(Form::strided);
        const Placed placed(round, round.size());
        const auto values = arbitrary_values<std::uint32_t>(round, placed.count);
        const auto others = arbitrary_values<std::uint32_t>(round, placed.extent);
        const Uints in(device(), round, placed, values);
        reductions::Line b(device(), placed.extent);
        b.write(others);
        const auto found = reductions::product_of_uints(device(), in.dense, in.step, placed.part<Part>(), in.length, b)
                               .await(device());
        const auto expected = std::inner_product(values.begin(), values.end(), others.begin() + placed.first, 0u);
        EXPECT_TRUE(equal(round, {expected}, std::vector<std::uint32_t>{found}));
    });
}

TEST_P(Reductions, InnerProductOfFloats) {
    for_all("inner_product of floats", [&](Round& round) {
        round.only(Form::dense);
        const Placed placed(round, round.size());
        const std::vector<float> x = float_values(round, placed.extent), y = float_values(round, placed.extent);
        reductions::Reals a(device(), placed.extent), b(device(), placed.extent);
        a.write(x);
        b.write(y);
        reductions::Line length(device(), 1);
        length.write(std::vector<glift::uint>{placed.count});
        const auto found = twice(round, [&] {
            return std::vector<float>{
                reductions::product_of_floats(device(), a, placed.part<Part>(), length, b).await(device())};
        });
        double sum = 0, sizes = 0;
        for (std::uint32_t i = placed.first; i < placed.first + placed.count; ++i) {
            sum += double(x[i]) * y[i];
            sizes += std::abs(double(x[i]) * y[i]);
        }
        EXPECT_TRUE(near(round, {sum}, {bound_of(sizes, placed.count + 1.0)}, found));
    });
}

TEST_P(Reductions, Equal) {
    for_all("equal", [&](Round& round) {
        round.only(Form::folded);
        const Placed placed(round, round.size());
        const auto values = arbitrary_values<std::uint32_t>(round, placed.count);
        const Uints in(device(), round, placed, values);
        std::vector<std::uint32_t> other = values;
        if (round.chance(4)) other.push_back(0);
        else if (!other.empty() && round.chance(4)) other.pop_back();
        if (!other.empty() && round.chance(2)) other[round.below(other.size())] ^= 1u << round.below(32);
        if (other.empty()) other.push_back(1);
        reductions::Line b(device(), static_cast<std::uint32_t>(other.size()));
        b.write(other);
        const auto found = reductions::is_equal(device(), in.folded, placed.part<Part>(), in.length, b).await(device());
        EXPECT_TRUE(equal(round, {values == other ? 1u : 0u}, std::vector<std::uint32_t>{found}));
    });
}

}  // namespace
