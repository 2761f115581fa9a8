// A page format that a user defines (tests/outside/tiles.glift: tiles of 4 x 16 in a hash map), which compiler, runtime
// and library do not know: random requests, boxes written and read by the host, samples and sorts, compared with
// std::unordered_map.
#include "property.h"

#include "tiles.glift.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

namespace {

using glift::uint2;
using property::Round;
using Number = std::uint32_t;

GLIFT_PROPERTY_SUITE(Tiles);

constexpr float background = -1;

class Sequence {
public:
    Sequence(const glift::Device& device, Round& round)
        : device_(device), round_(round), extent_{1 + round.below(60), 1 + round.below(90)},
          capacity_(1 + round.below(40)), sheet_(device, extent_, capacity_) {
        round_.about("extent " + std::to_string(extent_.x) + " x " + std::to_string(extent_.y) + ", capacity " +
                     std::to_string(capacity_));
    }

    void run() {
        for (int step = 0; step < 15 && !testing::Test::HasFailure(); ++step) {
            request();
            write();
            ASSERT_TRUE(box_is_right());
            ASSERT_TRUE(samples_are_right());
            ASSERT_TRUE(order_is_right());
        }
    }

private:
    uint2 tile_of(uint2 at) const { return {at.x / 4, at.y / 16}; }

    std::vector<uint2> places(Number most) {
        std::vector<uint2> made(1 + round_.below(most));
        for (uint2& place : made) place = {round_.below(extent_.x + 2), round_.below(extent_.y + 2)};
        return made;
    }

    /// Requests tiles. Only these are then resident; if they are more than fit, those of them that were resident
    /// before, and the first of the others in row-major order.
    void request() {
        const std::vector<uint2> asked = places(30);
        tiles::Places given(device_, static_cast<Number>(asked.size()));
        given.write(asked);
        tiles::request(device_, given, sheet_);
        sheet_.update(device_);
        std::set<std::pair<Number, Number>> wanted;  // row, column
        for (uint2 at : asked)
            if (at.x < extent_.x && at.y < extent_.y) wanted.emplace(at.y / 16, at.x / 4);
        std::erase_if(there_, [&](const auto& tile) { return !wanted.contains(tile); });
        for (const auto& tile : wanted) {
            if (there_.size() == capacity_) break;
            if (!there_.insert(tile).second) continue;
            for (Number i = 0; i < 64; ++i) values_[number_of({tile.second * 4 + i % 4, tile.first * 16 + i / 4})] = 0;
        }
    }

    static std::uint64_t number_of(uint2 at) { return std::uint64_t{at.y} << 32 | at.x; }

    /// An element in the model; null outside, or if its tile is not resident.
    float* element(uint2 at) {
        const bool is_there = at.x < extent_.x && at.y < extent_.y && there_.contains({at.y / 16, at.x / 4});
        return is_there ? &values_.at(number_of(at)) : nullptr;
    }
    float value(uint2 at) {
        const float* found = element(at);
        return found ? *found : background;
    }

    std::pair<uint2, uint2> box() {
        const uint2 first{round_.below(extent_.x), round_.below(extent_.y)};
        return {first, {1 + round_.below(extent_.x - first.x), 1 + round_.below(extent_.y - first.y)}};
    }

    void write() {
        const auto [first, size] = box();
        std::vector<float> given(size.x * size.y);
        for (Number i = 0; i < given.size(); ++i) {
            given[i] = static_cast<float>(round_.below(1000));
            if (float* at = element({first.x + i % size.x, first.y + i / size.x})) *at = given[i];
        }
        sheet_.field().write(first, size, given);
    }

    testing::AssertionResult box_is_right() {
        const auto [first, size] = box();
        std::vector<float> expected(size.x * size.y);
        for (Number i = 0; i < expected.size(); ++i) expected[i] = value({first.x + i % size.x, first.y + i / size.x});
        return property::equal(round_, expected, sheet_.field().read(first, size), "box");
    }

    /// Samples a quarter of an element beyond the centres of elements, along both axes.
    testing::AssertionResult samples_are_right() {
        const std::vector<uint2> asked = places(50);
        tiles::Places given(device_, static_cast<Number>(asked.size()));
        tiles::Values found(device_, static_cast<Number>(asked.size()));
        given.write(asked);
        tiles::between_places(device_, given, sheet_.field(), found);
        std::vector<double> exact, bounds;
        for (uint2 at : asked) {
            const auto along = [&](Number y) { return 0.75 * value({at.x, y}) + 0.25 * value({at.x + 1, y}); };
            exact.push_back(0.75 * along(at.y) + 0.25 * along(at.y + 1));
            bounds.push_back(1e-3);
        }
        return property::near(round_, exact, bounds, found.read(), "samples");
    }

    /// Where a resident tile extends beyond the sheet, its elements are unmapped: the sort and the sum take each as the
    /// background value.
    testing::AssertionResult order_is_right() {
        tiles::Values sorted(device_, capacity_ * 64), total(device_, 1);
        tiles::sort_there(device_, sheet_, sorted, total);
        std::vector<float> expected;
        double sum = 0;
        for (const auto& [row, column] : there_)
            for (Number i = 0; i < 64; ++i) expected.push_back(value({column * 4 + i % 4, row * 16 + i / 4}));
        for (const float each : expected) sum += each;
        std::ranges::sort(expected);
        std::vector<float> found = sorted.read();
        found.resize(expected.size());
        if (auto same = property::equal(round_, expected, found, "sorted"); !same) return same;
        return property::equal(round_, {static_cast<float>(sum)}, total.read(), "sum");  // of whole numbers: exact
    }

    glift::Device device_;
    Round& round_;
    uint2 extent_;
    Number capacity_;
    tiles::Sheet sheet_;
    std::set<std::pair<Number, Number>> there_;  ///< row, column
    std::unordered_map<std::uint64_t, float> values_;
};

TEST_P(Tiles, AreWhatAMapSays) {
    for_all("tiles of a user's own", [&](Round& round) { Sequence(device(), round).run(); });
}

}  // namespace
