// Compares scans with std::inclusive_scan, std::exclusive_scan and plain loops.
#include "input.h"

#include "scans.glift.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

/// `mirrored` of scans.glift on the host.
template <> scans::Affine property::mirrored(scans::Affine x) { return {x.offset, x.scale}; }

namespace {

using namespace property;
using forms::Part;
using scans::Affine;
using scans::Line;
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

/// However its n elements are grouped, each sum is within n u / (1 - n u) times the sum of their absolute values,
/// u = 2^-24 (Higham, Accuracy and Stability of Numerical Algorithms, 4.2), and has the same bits in each run; sums of
/// whole numbers are exact.
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

Affine composed(Affine f, Affine g) { return {f.scale * g.scale, g.scale * f.offset + g.offset}; }

TEST_P(Scans, InclusiveCompositions) {
    using In = Input<scans::Maps, scans::Maps, scans::Maps, Line>;
    for_all("inclusive_scan, compositions", [&](Round& round) {
        round.only(Form::mapped);
        const Placed placed(round, round.size());
        auto values = arbitrary_values<Affine>(round, placed.count);
        const In in(device(), round, placed, values);
        Output<scans::Maps> out(device(), round, placed);
        const auto found = twice(round, [&] {
            return out.after([&](const scans::Maps& to) {
                scans::inclusive_compositions(device(), in.dense, placed.part<Part>(), in.length, to);
            });
        });
        std::inclusive_scan(values.begin(), values.end(), values.begin(), composed);
        EXPECT_TRUE(equal(round, out.expected(placed, values), found));
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
        std::exclusive_scan(values.begin(), values.end(), values.begin(), Affine{1, 0}, composed);
        EXPECT_TRUE(equal(round, out.expected(placed, values), found));
    });
}

/// Flags, of which those that are not zero start segments: at random distances, or at nearly every element.
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

TEST_P(Scans, SegmentedExclusiveLast) {
    for_all("segmented_exclusive_scan, the last that is not zero", [&](Round& round) {
        round.only(Form::dense);
        const Placed placed(round, round.size());
        auto values = arbitrary_values<std::uint32_t>(round, placed.count);
        const std::uint32_t mean = 1 + round.below(100);
        for (std::uint32_t& x : values)
            if (!round.chance(mean)) x = 0;
        const auto segments = starts_of_segments(round, placed.extent);
        const Uints in(device(), round, placed, values);
        scans::Tiles starts(device(), placed.extent);
        starts.write(segments);
        Output<Line> out(device(), round, placed);
        const auto found = twice(round, [&] {
            return out.after([&](const Line& to) {
                scans::segmented_last(device(), in.dense, starts, placed.part<Part>(), in.length, to);
            });
        });
        std::vector<std::uint32_t> expected(placed.count);
        for (std::uint32_t i = 1; i < placed.count; ++i)
            if (segments[placed.first + i] == 0) expected[i] = values[i - 1] ? values[i - 1] : expected[i - 1];
        EXPECT_TRUE(equal(round, out.expected(placed, expected), found));
    });
}

}  // namespace
