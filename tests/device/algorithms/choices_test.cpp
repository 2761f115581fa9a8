// Compares compaction, partition, unique and run lengths with the C++ library's algorithms and with plain loops.
#include "chosen.h"
#include "input.h"

#include "choices.glift.hpp"

#include <algorithm>
#include <numeric>

namespace {

using namespace property;
using choices::Line;
using forms::Part;
using Values = std::vector<std::uint32_t>;
using Uints = Input<Line, choices::Folded, choices::Tiles, Line>;

GLIFT_PROPERTY_SUITE(Choices);

TEST_P(Choices, Compact) {
    for_all("compact", [&](Round& round) {
        static constexpr Form forms[] = {Form::dense, Form::folded, Form::mapped};
        round.only(forms[round.below(3)]);
        const Placed placed(round, round.size());
        const Values values = arbitrary_values<std::uint32_t>(round, placed.count);
        const std::uint32_t limit = limit_of(round);
        const Uints in(device(), round, placed, values);
        const Values before = arbitrary_values<std::uint32_t>(round, room_for(round, placed.count));
        Line to(device(), static_cast<std::uint32_t>(before.size()));
        const auto found = run_twice(device(), round, to, before, [&] {
            return choices::chosen(device(), in.form, in.dense, in.folded, placed.part<Part>(), in.length, limit, to);
        });
        Values expected;
        std::ranges::copy_if(values, std::back_inserter(expected), [&](std::uint32_t x) { return x < limit; });
        EXPECT_TRUE(start_with(round, before, expected, found));
    });
}

TEST_P(Choices, Partition) {
    for_all("partition", [&](Round& round) {
        round.only(Form::strided);
        const Placed placed(round, round.size());
        Values values = arbitrary_values<std::uint32_t>(round, placed.count);
        const std::uint32_t limit = limit_of(round);
        const Uints in(device(), round, placed, values);
        const Values before = arbitrary_values<std::uint32_t>(round, std::max(placed.count + round.below(50), 1u));
        Line to(device(), static_cast<std::uint32_t>(before.size()));
        auto found = run_twice(device(), round, to, before, [&] {
            return choices::set_apart(device(), in.dense, in.step, placed.part<Part>(), in.length, limit, to);
        });
        const auto middle =
            std::stable_partition(values.begin(), values.end(), [&](std::uint32_t x) { return x < limit; });
        EXPECT_TRUE(equal(round, {static_cast<std::uint32_t>(middle - values.begin())}, Values{found.count}, "count:"));
        found.count = placed.count;
        EXPECT_TRUE(start_with(round, before, values, found));
    });
}

TEST_P(Choices, Unique) {
    for_all("unique", [&](Round& round) {
        round.only(Form::dense);
        const Placed placed(round, round.size());
        const Values values = values_with_repeats<std::uint32_t>(round, placed.count);
        const Uints in(device(), round, placed, values);
        const Values before = arbitrary_values<std::uint32_t>(round, room_for(round, placed.count));
        Line to(device(), static_cast<std::uint32_t>(before.size()));
        const auto found = run_twice(device(), round, to, before, [&] {
            return choices::different(device(), in.dense, placed.part<Part>(), in.length, to);
        });
        Values expected;
        std::ranges::unique_copy(values, std::back_inserter(expected));
        EXPECT_TRUE(start_with(round, before, expected, found));
    });
}

TEST_P(Choices, RunLengths) {
    for_all("run_lengths", [&](Round& round) {
        round.only(Form::tiled);
        const Placed placed(round, round.size());
        const Values values = values_with_repeats<std::uint32_t>(round, placed.count);
        const Uints in(device(), round, placed, values);
        const Values before = arbitrary_values<std::uint32_t>(round, room_for(round, placed.count));
        const auto room = static_cast<std::uint32_t>(before.size());
        Line to(device(), room), lengths(device(), room);
        lengths.write(before);
        const auto found = run_twice(device(), round, to, before, [&] {
            return choices::runs(device(), in.tiled, placed.part<Part>(), in.length, to, lengths);
        });
        Values expected, expected_lengths;
        for (std::uint32_t i = 0; i < placed.count; ++i) {
            if (i == 0 || values[i] != values[i - 1]) {
                expected.push_back(values[i]);
                expected_lengths.push_back(0);
            }
            ++expected_lengths.back();
        }
        EXPECT_TRUE(start_with(round, before, expected, found, "values:"));
        EXPECT_TRUE(
            start_with(round, before, expected_lengths, Found<std::uint32_t>{lengths.read(), found.count}, "lengths:"));
    });
}

TEST_P(Choices, OneAlgorithmAfterAnother) {
    for_all("compact, sort, unique, inclusive_scan", [&](Round& round) {
        round.only(Form::dense);
        round.only(Taken::whole);
        const std::uint32_t count = std::max(round.size(), 1u);
        round.has_size(count);
        const Values values = values_with_repeats<std::uint32_t>(round, count);
        const std::uint32_t limit = round.chance(4) ? limit_of(round) : values[round.below(count)];
        Line from(device(), count), to(device(), count), sums(device(), count);
        from.write(values);
        const Values before = arbitrary_values<std::uint32_t>(round, count);
        sums.write(before);
        const auto found =
            run_twice(device(), round, to, before, [&] { return choices::chained(device(), from, limit, to, sums); });
        Values expected;
        std::ranges::copy_if(values, std::back_inserter(expected), [&](std::uint32_t x) { return x < limit; });
        std::ranges::sort(expected);
        expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
        EXPECT_TRUE(start_with(round, before, expected, found));
        std::inclusive_scan(expected.begin(), expected.end(), expected.begin());
        EXPECT_TRUE(start_with(round, before, expected, Found<std::uint32_t>{sums.read(), found.count}, "sums:"));
    });
}

}  // namespace
