// Sparse arrays with pools of many sizes and page tables of one and two levels: random requests, releases, writes,
// refinements and reads, compared with a model after each change: status, table, frames, free list, and every element
// of every page.
#include "model.h"
#include "places.h"
#include "property.h"

#include "sparse.glift.hpp"

namespace {

using glift::uint2;
using model::Number;
using property::Round;

GLIFT_PROPERTY_SUITE(Sparse);

constexpr Number background = 77, page_x = 4, page_y = 2, page_volume = page_x * page_y, unmapped = 0xffffffff;
constexpr Number leaf_entries = 5;  ///< entries in a page of the lower level of a table

template <class Grid> class Sequence {
public:
    Sequence(const glift::Device& device, Round& round, model::Overflow policy)
        : device_(device),
          round_(round), extent_{1 + round.below(60), 1 + round.below(40)}, along_{(extent_.x + page_x - 1) / page_x,
                                                                                   (extent_.y + page_y - 1) / page_y},
          capacity_(std::max(1u, along_.x * along_.y >> 1 >> round.below(4) >> round.below(2))),
          pages_(policy, along_.x * along_.y, capacity_), leaves_(leaves_of(policy)),
          grid_(device, extent_, capacity_, background) {
        round_.about(std::string("extent ") + std::to_string(extent_.x) + " x " + std::to_string(extent_.y) +
                     ", capacity " + std::to_string(capacity_));
    }

    void run() {
        for (int step = 0; step < 30 && !testing::Test::HasFailure(); ++step) {
            request();
            if (round_.chance(2)) release();
            change();
            if (round_.chance(2)) write();
            if (round_.chance(5)) compact();
            ASSERT_TRUE(layout_is_right(step));
            ASSERT_TRUE(reads_are_right());
        }
    }

private:
    /// The model of the pages of a two-level table's lower level. Their pool has room for one page per frame of the
    /// field, but for no more pages than the level has; if the field may grow, for all of them.
    model::Pages leaves_of(model::Overflow policy) const {
        const Number all = (along_.x * along_.y + leaf_entries - 1) / leaf_entries;
        return {model::Overflow::drop, all, policy == model::Overflow::grow ? all : std::min(all, capacity_)};
    }

    Number page_of(uint2 place) const { return place.y / page_y * along_.x + place.x / page_x; }
    bool is_inside(uint2 place) const { return place.x < extent_.x && place.y < extent_.y; }
    static Number element_of(uint2 place) { return place.y % page_y * page_x + place.x % page_x; }

    std::vector<uint2> places(Number most) { return property::places_near(round_, extent_, most, 64); }

    sparse::Places on_device(const std::vector<uint2>& all) {
        sparse::Places made(device_, static_cast<Number>(all.size()));
        made.write(all);
        return made;
    }

    void request() {
        const std::vector<uint2> asked = places(60);
        sparse::request(device_, on_device(asked), grid_);
        for (uint2 place : asked)
            if (is_inside(place)) pages_.request(page_of(place));
    }

    void release() {
        const std::vector<uint2> asked = places(40);
        sparse::release(device_, on_device(asked), grid_);
        for (uint2 place : asked)
            if (is_inside(place)) pages_.release(page_of(place));
    }

    void change() {
        const bool releases = round_.chance(3);
        if (releases) grid_.update(device_);
        else grid_.allocate(device_);
        std::vector<Number> granted = pages_.change(releases);
        for (const auto& [page, frame] : pages_.frames()) leaves_.request(page / leaf_entries);
        leaves_.change(true);
        const bool refines = round_.chance(2);
        const Number by = round_.below(1000000);
        if (refines) sparse::refine(device_, grid_, by);
        contents_.resize(pages_.status().capacity * page_volume);
        for (Number page : granted)
            for (Number i = 0; i < page_volume; ++i) {
                const uint2 at{page % along_.x * page_x + i % page_x, page / along_.x * page_y + i / page_x};
                contents_[pages_.frames().at(page) * page_volume + i] =
                    refines && is_inside(at) ? at.x + 1000 * at.y + by : background;
            }
    }

    void write() {
        std::vector<uint2> at = places(80);
        std::ranges::sort(at, [](uint2 a, uint2 b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
        at.erase(std::ranges::unique(at).begin(), at.end());
        std::vector<Number> values(at.size());
        for (Number& value : values) value = round_.below(1u << 31);
        sparse::Values given(device_, static_cast<Number>(values.size()));
        given.write(values);
        sparse::write_field(device_, on_device(at), given, grid_.field());
        for (std::size_t i = 0; i < at.size(); ++i)
            if (Number* place = element(at[i])) *place = values[i];
    }

    void compact() {
        grid_.compact(device_);
        const std::vector<Number> before = contents_;
        for (const auto& [from, to] : pages_.compact())
            std::copy_n(before.begin() + from * page_volume, page_volume, contents_.begin() + to * page_volume);
    }

    /// An element in the model; null outside, or if its page is not resident.
    Number* element(uint2 place) {
        if (!is_inside(place)) return nullptr;
        const auto at = pages_.frames().find(page_of(place));
        return at == pages_.frames().end() ? nullptr : &contents_[at->second * page_volume + element_of(place)];
    }

    testing::AssertionResult layout_is_right(int step) {
        const auto status = grid_.status(device_);
        const model::Status found{status.requested, status.granted, status.refused, status.resident, status.capacity};
        if (!(found == pages_.status())) return round_.wrong("status after step " + std::to_string(step));
        const auto& pages = grid_.pages();
        std::vector<Number> table(along_.x * along_.y), owners(found.capacity), active, used = pages.used().read();
        const std::vector<Number> found_used = used;
        for (const auto& [page, frame] : pages_.frames()) {
            used[frame] = pages_.used(page);
            table[page] = frame + 1;
            owners[frame] = page + 1;
            active.push_back(page);
        }
        const auto start = [](std::vector<Number> all, std::size_t n) {
            all.resize(n);
            return all;
        };
        if (auto same = property::equal(round_, table, grid_.table().read(), "table"); !same) return same;
        if (auto same = property::equal(round_, owners, pages.owners().read(), "owners"); !same) return same;
        if (auto same = property::equal(round_, used, found_used, "used"); !same) return same;
        if (auto same = property::equal(round_, active, start(pages.active().read(), active.size()), "active"); !same)
            return same;
        if (auto same = tables_are_right(); !same) return same;
        const std::vector<Number>& free = pages_.free();
        if (auto same = property::equal(round_, free, start(pages.free().read(), free.size()), "free"); !same)
            return same;
        return property::equal(round_, contents_, grid_.field().frames().read(), "frames");
    }

    /// Checks a two-level table: those pages of the lower level are resident that have entries, and the upper level
    /// names their frames.
    testing::AssertionResult tables_are_right() {
        if constexpr (requires { grid_.leaves(); }) {
            std::vector<Number> top(leaves_.bound()), owners(leaves_.status().capacity), active;
            for (const auto& [leaf, frame] : leaves_.frames()) {
                top[leaf] = frame + 1;
                owners[frame] = leaf + 1;
                active.push_back(leaf);
            }
            if (auto same = property::equal(round_, top, grid_.top().read(), "upper table"); !same) return same;
            if (auto same = property::equal(round_, owners, grid_.leaves().owners().read(), "owners of parts"); !same)
                return same;
            std::vector<Number> found = grid_.leaves().active().read();
            found.resize(active.size());
            return property::equal(round_, active, found, "parts that are there");
        }
        return testing::AssertionSuccess();
    }

    testing::AssertionResult reads_are_right() {
        const std::vector<uint2> at = places(100);
        const sparse::Places asked = on_device(at);
        const sparse::Values read(device_, static_cast<Number>(at.size())),
            found(device_, static_cast<Number>(at.size()));
        sparse::read_field(device_, asked, grid_.field(), read);
        sparse::find_field(device_, asked, grid_.field(), found);
        std::vector<Number> expected_read, expected_found;
        for (uint2 place : at) {
            const Number* value = element(place);
            expected_read.push_back(value ? *value : background);
            expected_found.push_back(value ? *value : unmapped);
        }
        if (auto same = property::equal(round_, expected_read, read.read(), "read"); !same) return same;
        return property::equal(round_, expected_found, found.read(), "find");
    }

    glift::Device device_;
    Round& round_;
    uint2 extent_, along_;
    Number capacity_;
    model::Pages pages_;
    model::Pages leaves_;  ///< pages of the table's lower level, where it has two levels
    Grid grid_;
    std::vector<Number> contents_ = std::vector<Number>(capacity_ * page_volume);  ///< contents of all frames
};

/// A step of a simulation: requests and the change that they ask for are one submission, and nothing is read back.
TEST_P(Sparse, RecordedOnce) {
    for_all("sparse array, recorded", [&](Round& round) {
        const uint2 extent{200, 100};
        const Number most = 300, along = extent.x / page_x, bound = along * extent.y / page_y;
        const Number capacity = 1 + round.below(most);
        sparse::Evict grid(device(), extent, capacity, background);
        model::Pages pages(model::Overflow::evict, bound, capacity);
        sparse::Places places(device(), most);
        const auto step = device().record([&](const glift::Commands& commands) {
            sparse::request(commands, places, grid);
            grid.allocate(commands);
        });
        for (int i = 0; i < 8 && !HasFailure(); ++i) {
            std::vector<uint2> asked(most);
            for (uint2& place : asked) place = {round.below(40) + round.below(160), round.below(100)};
            places.write(asked);
            device().wait();
            const glift::Statistics before = device().statistics();
            step.submit();
            EXPECT_LE(device().statistics().submissions - before.submissions, 1u);  // the host device has none
            EXPECT_EQ(device().statistics().waits - before.waits, 0u);
            for (uint2 place : asked) pages.request(place.y / page_y * along + place.x / page_x);
            pages.change(false);
            std::vector<Number> table(bound);
            for (const auto& [page, frame] : pages.frames()) table[page] = frame + 1;
            ASSERT_TRUE(property::equal(round, table, grid.table().read(), "table"));
            ASSERT_EQ(grid.status(device()).refused, pages.status().refused);
        }
    });
}

TEST_P(Sparse, Drop) {
    for_all("sparse array, drop",
            [&](Round& round) { Sequence<sparse::Drop>(device(), round, model::Overflow::drop).run(); });
}

TEST_P(Sparse, Fail) {
    for_all("sparse array, fail",
            [&](Round& round) { Sequence<sparse::Fail>(device(), round, model::Overflow::fail).run(); });
}

TEST_P(Sparse, Evict) {
    for_all("sparse array, evict",
            [&](Round& round) { Sequence<sparse::Evict>(device(), round, model::Overflow::evict).run(); });
}

TEST_P(Sparse, Grow) {
    for_all("sparse array, grow",
            [&](Round& round) { Sequence<sparse::Grow>(device(), round, model::Overflow::grow).run(); });
}

TEST_P(Sparse, TwoLevelsDrop) {
    for_all("sparse array of two levels, drop",
            [&](Round& round) { Sequence<sparse::TwoLevelDrop>(device(), round, model::Overflow::drop).run(); });
}

TEST_P(Sparse, TwoLevelsFail) {
    for_all("sparse array of two levels, fail",
            [&](Round& round) { Sequence<sparse::TwoLevelFail>(device(), round, model::Overflow::fail).run(); });
}

TEST_P(Sparse, TwoLevelsEvict) {
    for_all("sparse array of two levels, evict",
            [&](Round& round) { Sequence<sparse::TwoLevelEvict>(device(), round, model::Overflow::evict).run(); });
}

TEST_P(Sparse, TwoLevelsGrow) {
    for_all("sparse array of two levels, grow",
            [&](Round& round) { Sequence<sparse::TwoLevelGrow>(device(), round, model::Overflow::grow).run(); });
}

}  // namespace
