// The neighbours that a grid of lists finds, compared with all pairs of particles, as sets. Particles are anywhere in
// the box, on its sides, and several at one point.
#include "property.h"

#include "neighbours.glift.hpp"

#include <algorithm>

namespace {

using glift::float3, glift::uint2, glift::uint3;
using property::Round;
using Number = std::uint32_t;

GLIFT_PROPERTY_SUITE(Neighbours);

std::vector<neighbours::Numbered> particles(Round& round, uint3 cells, Number n) {
    std::vector<neighbours::Numbered> made(n);
    // Most particles are in a part of the box, so that some have many neighbours and some cells are empty.
    const float part = 0.3f + 0.7f * static_cast<float>(std::abs(round.real()));
    const auto along = [&](Number axis) {
        const float side = static_cast<float>(axis);
        return round.chance(20) ? side * static_cast<float>(round.below(2))
                                : part * side * static_cast<float>(std::abs(round.real()));
    };
    for (Number i = 0; i < n; ++i) {
        made[i] = {{along(cells.x), along(cells.y), along(cells.z)}, i};
        if (i > 0 && round.chance(30)) made[i].at = made[round.below(i)].at;
    }
    return made;
}

/// For each particle the numbers of its neighbours, itself included, ascending: by comparing all pairs.
std::vector<std::vector<Number>> by_comparison(const std::vector<neighbours::Numbered>& all, float radius) {
    std::vector<std::vector<Number>> found(all.size());
    for (const auto& own : all)
        for (const auto& other : all) {
            const float3 d = other.at - own.at;
            if (d.x * d.x + d.y * d.y + d.z * d.z < radius * radius) found[own.number].push_back(other.number);
        }
    return found;
}

TEST_P(Neighbours, AreThoseOfAComparisonOfAllWithAll) {
    for_all("neighbours", [&](Round& round) {
        const uint3 cells{1 + round.below(12), 1 + round.below(9), 1 + round.below(7)};
        const Number n = 1 + round.below(std::min<Number>(8 * cells.x * cells.y * cells.z, property::limit() / 8));
        const float radius = round.chance(2) ? 1.0f : 0.4f;
        round.about("cells " + std::to_string(cells.x) + " x " + std::to_string(cells.y) + " x " +
                    std::to_string(cells.z) + ", particles " + std::to_string(n));
        const std::vector<neighbours::Numbered> all = particles(round, cells, n);
        const std::vector<std::vector<Number>> expected = by_comparison(all, radius);
        Number most = 0;
        for (const auto& some : expected) most = std::max(most, static_cast<Number>(some.size()));
        neighbours::Places places(device(), n);
        neighbours::Grid grid(device(), cells.x * cells.y * cells.z, n);
        neighbours::Found found(device(), uint2{most, n});
        neighbours::Numbers counts(device(), n);
        places.write(all);
        neighbours::neighbours_of(device(), places, grid, cells, radius, found, counts);
        const std::vector<Number> count = counts.read(), lists = found.read();
        for (Number i = 0; i < n; ++i) {
            ASSERT_EQ(count[i], expected[i].size()) << round.wrong("neighbours of " + std::to_string(i)).message();
            const auto first = lists.begin() + static_cast<std::ptrdiff_t>(i) * most;
            std::vector<Number> own(first, first + count[i]);
            std::ranges::sort(own);
            ASSERT_TRUE(property::equal(round, expected[i], own, "neighbours"));
        }
    });
}

/// A step of a simulation is one submission, and nothing is read back; replays find as many neighbours as a comparison
/// of all pairs.
TEST_P(Neighbours, ComeWithOneSubmission) {
    for_all("neighbours, recorded", [&](Round& round) {
        const uint3 cells{6, 5, 4};
        const Number n = 500, most = 200;
        neighbours::Places places(device(), n);
        neighbours::Grid grid(device(), 6 * 5 * 4, n);
        neighbours::Found found(device(), uint2{most, n});
        neighbours::Numbers counts(device(), n);
        const auto step = device().record([&](const glift::Commands& commands) {
            neighbours::neighbours_of(commands, places, grid, cells, 1.0f, found, counts);
        });
        for (int i = 0; i < 3 && !HasFailure(); ++i) {
            const std::vector<neighbours::Numbered> all = particles(round, cells, n);
            places.write(all);
            device().wait();
            const glift::Statistics before = device().statistics();
            step.submit();
            EXPECT_LE(device().statistics().submissions - before.submissions, 1u);  // the host device has none
            EXPECT_EQ(device().statistics().waits - before.waits, 0u);
            std::vector<Number> expected;
            for (const auto& some : by_comparison(all, 1.0f)) expected.push_back(static_cast<Number>(some.size()));
            ASSERT_TRUE(property::equal(round, expected, counts.read(), "counts"));
        }
    });
}

}  // namespace
