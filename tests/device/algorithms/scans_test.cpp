// Scans beside std::inclusive_scan and std::exclusive_scan.
#include "input.h"

#include "scans.glift.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

using namespace property;
using scans::Affine;
using scans::Line;
using scans::Part;
using Uints = Input<Line, scans::Folded, scans::Tiles, Line>;

GLIFT_PROPERTY_SUITE(Scans);

Line length_of(const glift::Device& device, const Placed& placed) {
    Line length(device, 1);
    length.write(std::vector<glift::uint>{placed.count});
    return length;
}

TEST_P(Scans, InclusiveSums) {
    for_all("inclusive_scan, sums of uints", [&](Round& round) {
        round.only(round.seed() % 2 ? Form::folded : Form::dense);
        const Placed placed(round, round.size());
        auto values = arbitrary_values<std::uint32_t>(round, placed.count);
        const Uints in(device(), round, placed, values);
        Output<Line> out(device(), round, placed);
        const auto found = twice(round, [&] {
            return out.after([&](const Line& to) {
                scans::inclusive_sums(device(), in.form, in.dense, in.folded, placed.part<Part>(), in.length, to);
            });
        });
        std::inclusive_scan(values.begin(), values.end(), values.begin());
        EXPECT_TRUE(equal(round, out.expected(placed, values), found));
    });
}

TEST_P(Scans, ExclusiveSumsToAnImage) {
    for_all("exclusive_scan, sums of uints to an image", [&](Round& round) {
        round.only(Form::mapped);
        const Placed placed(round, round.size());
        auto values = arbitrary_values<std::uint32_t>(round, placed.count);
        const Uints in(device(), round, placed, values);
        Output<scans::Folded> out(device(), round, placed);
        const auto found = out.after([&](const scans::Folded& to) {
            scans::exclusive_sums(device(), in.dense, placed.part<Part>(), in.length, to);
        });
        std::exclusive_scan(values.begin(), values.end(), values.begin(), 0u);
        EXPECT_TRUE(equal(round, out.expected(placed, values), found));
    });
}

/// Each is within (n - 1) u / (1 - (n - 1) u) of the sum of sizes up to it, however grouped (Higham, 4.2), and the same
/// bits in each run; whole numbers come out exactly.
TEST_P(Scans, SumsOfFloats) {
    for_all("exclusive_scan, sums of floats", [&](Round& round) {
        round.only(Form::dense);
        const Placed placed(round, round.size());
        const bool exact = round.chance(2);
        std::vector<float> all(placed.extent);
        for (float& x : all)
            x = exact ? float(round.below(17)) - 8 : float(round.real() * std::exp2(round.real() * 10));
        scans::Reals from(device(), placed.extent);
        from.write(all);
        const Line length = length_of(device(), placed);
        Output<scans::Reals> out(device(), round, placed);
        const auto found = twice(round, [&] {
            return out.after(
                [&](const scans::Reals& to) { scans::float_sums(device(), from, placed.part<Part>(), length, to); });
        });
        std::vector<double> expected(out.before.begin(), out.before.end()), bounds(placed.extent);
        double sum = 0, sizes = 0;
        for (std::uint32_t i = 0; i < placed.count; ++i) {
            const double nu = i * 0x1p-24;
            expected[placed.first + i] = sum;
            bounds[placed.first + i] = exact && sizes < 0x1p24 ? 0 : nu < 0.5 ? sizes * nu / (1 - nu) : INFINITY;
            sum += all[placed.first + i];
            sizes += std::abs(all[placed.first + i]);
        }
        EXPECT_TRUE(near(round, expected, bounds, found));
    });
}

TEST_P(Scans, AnOperatorThatDoesNotCommute) {
    for_all("exclusive_scan, compositions", [&](Round& round) {
        round.only(Form::dense);
        const Placed placed(round, round.size());
        std::vector<Affine> all(placed.extent);
        for (Affine& f : all) f = {arbitrary<std::uint32_t>(round), arbitrary<std::uint32_t>(round)};
        scans::Maps from(device(), placed.extent);
        from.write(all);
        const Line length = length_of(device(), placed);
        Output<scans::Maps> out(device(), round, placed);
        const auto found = twice(round, [&] {
            return out.after(
                [&](const scans::Maps& to) { scans::compositions(device(), from, placed.part<Part>(), length, to); });
        });
        std::vector<Affine> values(all.begin() + placed.first, all.begin() + placed.first + placed.count);
        std::exclusive_scan(values.begin(), values.end(), values.begin(), Affine{1, 0}, [](Affine f, Affine g) {
            return Affine{f.scale * g.scale, g.scale * f.offset + g.offset};
        });
        EXPECT_TRUE(equal(round, out.expected(placed, values), found));
    });
}

/// Starts of segments of any length, or at every element, or nowhere.
std::vector<std::uint32_t> starts_of_segments(Round& round, std::uint32_t count) {
    std::vector<std::uint32_t> starts(count);
    const std::uint32_t mean = round.chance(4) ? 1 : 1 + round.below(round.chance(2) ? 10 : 5000);
    for (std::uint32_t& start : starts) start = round.chance(mean) ? arbitrary<std::uint32_t>(round) : 0;
    return starts;
}

TEST_P(Scans, SegmentedSums) {
    for_all("segmented_inclusive_scan, sums of uints", [&](Round& round) {
        const Placed placed(round, round.size());
        auto values = arbitrary_values<std::uint32_t>(round, placed.count);
        const auto segments = starts_of_segments(round, placed.extent);
        const Uints in(device(), round, placed, values);
        Line starts(device(), placed.extent);
        starts.write(segments);
        Output<Line> out(device(), round, placed);
        const auto found = twice(round, [&] {
            return out.after([&](const Line& to) {
                scans::segmented_sums(device(), in.form, in.dense, in.folded, in.tiled, in.step, placed.part<Part>(),
                                      in.length, starts, to);
            });
        });
        for (std::uint32_t i = 1; i < placed.count; ++i)
            if (segments[placed.first + i] == 0) values[i] += values[i - 1];
        EXPECT_TRUE(equal(round, out.expected(placed, values), found));
    });
}

TEST_P(Scans, SegmentedExclusiveMaxima) {
    for_all("segmented_exclusive_scan, maxima of uints", [&](Round& round) {
        round.only(Form::dense);
        round.only(Taken::whole);
        const std::uint32_t n = std::max(round.size(), 1u);
        round.has_size(n);
        const auto values = arbitrary_values<std::uint32_t>(round, n);
        const auto segments = starts_of_segments(round, n);
        Line from(device(), n), starts(device(), n), to(device(), n);
        from.write(values);
        starts.write(segments);
        scans::segmented_maxima(device(), from, starts, to);
        std::vector<std::uint32_t> expected(n);
        for (std::uint32_t i = 1; i < n; ++i)
            if (segments[i] == 0) expected[i] = std::max(expected[i - 1], values[i - 1]);
        EXPECT_TRUE(equal(round, expected, to.read()));
    });
}

}  // namespace
