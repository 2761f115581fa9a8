// Compares transforms, fills, gathers, scatters, reversals and histograms with the C++ library's and with plain loops.
#include "input.h"

#include "moves.glift.hpp"

#include <algorithm>
#include <numeric>

namespace {

using namespace property;
using forms::Part;
using moves::Line;
using Values = std::vector<std::uint32_t>;
using Uints = Input<Line, moves::Folded, moves::Tiles, Line>;

GLIFT_PROPERTY_SUITE(Moves);

TEST_P(Moves, Transform) {
    for_all("transform", [&](Round& round) {
        const Placed placed(round, round.size());
        const Values values = arbitrary_values<std::uint32_t>(round, placed.count);
        const Uints in(device(), round, placed, values);
        Output<moves::Reals> out(device(), round, placed);
        const auto scale = float(round.real()), offset = float(round.real() * 1e6);
        const auto found = out.after([&](const moves::Reals& to) {
            moves::transformed(device(), in.form, in.dense, in.folded, in.tiled, in.step, placed.part<Part>(),
                               in.length, scale, offset, to);
        });
        std::vector<float> expected(values.size());
        std::ranges::transform(values, expected.begin(), [&](std::uint32_t x) {
            const float product = scale * float(x >> 8);
            return product + offset;
        });
        EXPECT_TRUE(equal(round, out.expected(placed, expected), found));
    });
}

TEST_P(Moves, TransformPairs) {
    for_all("transform_pairs", [&](Round& round) {
        round.only(Form::folded);
        const Placed placed(round, round.size());
        Values values = arbitrary_values<std::uint32_t>(round, placed.count);
        const Uints in(device(), round, placed, values);
        const Values others = arbitrary_values<std::uint32_t>(round, placed.extent);
        Line b(device(), placed.extent);
        b.write(others);
        Output<moves::Tiles> out(device(), round, placed);
        const auto found = out.after(
            [&](const moves::Tiles& to) { moves::mixed(device(), in.folded, placed.part<Part>(), in.length, b, to); });
        std::transform(values.begin(), values.end(), others.begin() + placed.first, values.begin(),
                       [](std::uint32_t x, std::uint32_t y) { return 3 * x ^ y; });
        EXPECT_TRUE(equal(round, out.expected(placed, values), found));
    });
}

TEST_P(Moves, Gather) {
    for_all("gather", [&](Round& round) {
        const Placed placed(round, round.size());
        const Values values = arbitrary_values<std::uint32_t>(round, placed.count);
        const Uints in(device(), round, placed, values);
        Values places(std::max(round.size(), 1u)), expected;
        // Beyond the part, a view still computes elements, where other forms give 0: so indices into views stay inside.
        const bool view = round.form() == Form::strided || round.form() == Form::mapped;
        if (view && placed.count == 0) return;
        for (std::uint32_t& place : places) {
            // Some indices are just beyond the end, a few far beyond.
            place = round.below(placed.count + (view ? 0 : std::uint64_t{3}));
            if (!view && round.chance(100)) place = UINT32_MAX - round.below(3);
            expected.push_back(place < placed.count ? values[place] : 0);
        }
        const auto count = static_cast<std::uint32_t>(places.size());
        Line indices(device(), count), to(device(), count);
        indices.write(places);
        to.fill(77);
        moves::gathered(device(), in.form, in.dense, in.folded, in.tiled, in.step, placed.part<Part>(), in.length,
                        indices, to);
        EXPECT_TRUE(equal(round, expected, to.read()));
    });
}

TEST_P(Moves, Scatter) {
    for_all("scatter", [&](Round& round) {
        const Placed placed(round, round.size());
        const Values values = arbitrary_values<std::uint32_t>(round, placed.count);
        const Uints in(device(), round, placed, values);
        // Each index occurs at most once; some are out of range.
        const std::uint32_t room = std::max(placed.count + round.below(100), 1u);
        Values places(std::max(placed.extent, room + 5));
        std::iota(places.begin(), places.end(), 0u);
        std::shuffle(places.begin(), places.end(), round.engine());
        places.resize(placed.extent);
        Line indices(device(), placed.extent);
        indices.write(places);
        Values expected = arbitrary_values<std::uint32_t>(round, room);
        moves::Folded to(device(), room);
        to.write(expected);
        moves::scattered(device(), in.form, in.dense, in.folded, in.tiled, in.step, placed.part<Part>(), in.length,
                         indices, to);
        for (std::uint32_t i = 0; i < placed.count; ++i) {
            const std::uint32_t place = places[placed.first + i];
            if (place < room) expected[place] = values[i];
        }
        EXPECT_TRUE(equal(round, expected, to.read()));
    });
}

TEST_P(Moves, Fill) {
    for_all("fill", [&](Round& round) {
        round.only(Form::tiled);
        const Placed placed(round, round.size());
        Line length(device(), 1);
        length.write(Values{placed.count});
        Output<moves::Tiles> out(device(), round, placed);
        const auto value = arbitrary<std::uint32_t>(round);
        const auto found =
            out.after([&](const moves::Tiles& to) { moves::filled(device(), placed.part<Part>(), length, value, to); });
        EXPECT_TRUE(equal(round, out.expected(placed, Values(placed.count, value)), found));
    });
}

TEST_P(Moves, Reverse) {
    for_all("reverse", [&](Round& round) {
        round.only(Form::tiled);
        const Placed placed(round, round.size());
        Values values = arbitrary_values<std::uint32_t>(round, placed.count);
        const Uints in(device(), round, placed, values);
        Output<Line> out(device(), round, placed);
        const auto found =
            out.after([&](const Line& to) { moves::reversed(device(), in.tiled, placed.part<Part>(), in.length, to); });
        std::ranges::reverse(values);
        EXPECT_TRUE(equal(round, out.expected(placed, values), found));
    });
}

TEST_P(Moves, Histogram) {
    for_all("histogram", [&](Round& round) {
        const Placed placed(round, round.size());
        // Now and then about 1024 bins, the most that histogram counts in workgroup memory.
        const std::uint32_t bins =
            round.chance(3) ? 1023 + round.below(3) : 1 + round.below(round.chance(2) ? 20 : 5000);
        Values values(placed.count);
        const std::uint32_t kinds = round.chance(4) ? 1 : bins + round.below(3);
        for (std::uint32_t& x : values) x = round.chance(50) ? arbitrary<std::uint32_t>(round) : round.below(kinds);
        const Uints in(device(), round, placed, values);
        Line counts(device(), bins);
        const auto found = twice(round, [&] {
            counts.fill(77);
            moves::how_often(device(), in.form, in.dense, in.folded, in.tiled, in.step, placed.part<Part>(), in.length,
                             counts);
            return counts.read();
        });
        Values expected(bins);
        for (std::uint32_t x : values)
            if (x < bins) ++expected[x];
        EXPECT_TRUE(equal(round, expected, found));
    });
}

}  // namespace
