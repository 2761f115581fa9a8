// Sparse arrays with bump allocators: random requests, writes, reads and releases of all pages, compared with a model
// after each change: status, table, order of pages, and every element of every frame.
#include "model.h"
#include "places.h"
#include "property.h"

#include "bump.glift.hpp"

namespace {

using glift::uint2;
using model::Number;
using property::Round;

GLIFT_PROPERTY_SUITE(Bump);

constexpr Number background = 77, page_x = 4, page_y = 2, page_volume = page_x * page_y, unmapped = 0xffffffff;

template <class Grid> class Sequence {
public:
    Sequence(const glift::Device& device, Round& round, model::Overflow policy)
        : device_(device), round_(round),
          policy_(policy), extent_{1 + round.below(60), 1 + round.below(40)}, along_{(extent_.x + page_x - 1) / page_x,
                                                                                     (extent_.y + page_y - 1) / page_y},
          capacity_(std::max(1u, along_.x * along_.y >> round.below(5))),
          pages_(policy, along_.x * along_.y, capacity_), grid_(device, extent_, capacity_, background) {
        round_.about("extent " + std::to_string(extent_.x) + " x " + std::to_string(extent_.y) + ", capacity " +
                     std::to_string(capacity_));
    }

    void run() {
        for (int step = 0; step < 20 && !testing::Test::HasFailure(); ++step) {
            if (round_.chance(8)) release();
            request();
            change();
            if (round_.chance(2)) write();
            ASSERT_TRUE(layout_is_right());
            ASSERT_TRUE(reads_are_right());
        }
    }

private:
    Number page_of(uint2 place) const { return place.y / page_y * along_.x + place.x / page_x; }
    bool is_inside(uint2 place) const { return place.x < extent_.x && place.y < extent_.y; }

    std::vector<uint2> places(Number most) { return property::places_near(round_, extent_, most, 30); }

    bump::Places on_device(const std::vector<uint2>& all) {
        bump::Places made(device_, static_cast<Number>(all.size()));
        made.write(all);
        return made;
    }

    void request() {
        const std::vector<uint2> asked = places(30);
        bump::request(device_, on_device(asked), grid_);
        for (uint2 place : asked)
            if (is_inside(place)) pages_.request(page_of(place));
    }

    void change() {
        grid_.allocate(device_);
        granted_ = pages_.change(false);
        order_.insert(order_.end(), granted_.begin(), granted_.end());
        contents_.resize(pages_.status().capacity * page_volume);
        for (Number page : granted_)
            std::fill_n(contents_.begin() + pages_.frames().at(page) * page_volume, page_volume, background);
    }

    /// Releases all pages. Frames keep their contents until they are granted again.
    void release() {
        grid_.release_all(device_);
        pages_ = model::Pages(policy_, along_.x * along_.y, pages_.status().capacity);
        order_.clear();
    }

    void write() {
        std::vector<uint2> at = places(80);
        std::ranges::sort(at, [](uint2 a, uint2 b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
        at.erase(std::ranges::unique(at).begin(), at.end());
        std::vector<Number> values(at.size());
        for (Number& value : values) value = round_.below(1u << 31);
        bump::Values given(device_, static_cast<Number>(values.size()));
        given.write(values);
        bump::write_field(device_, on_device(at), given, grid_.field());
        for (std::size_t i = 0; i < at.size(); ++i)
            if (Number* place = element(at[i])) *place = values[i];
    }

    /// An element in the model; null outside, or if its page is not resident.
    Number* element(uint2 place) {
        if (!is_inside(place)) return nullptr;
        const auto at = pages_.frames().find(page_of(place));
        if (at == pages_.frames().end()) return nullptr;
        return &contents_[at->second * page_volume + place.y % page_y * page_x + place.x % page_x];
    }

    testing::AssertionResult layout_is_right() {
        const auto status = grid_.status(device_);
        const model::Status found{status.requested, status.granted, status.refused, status.resident, status.capacity};
        if (!(found == pages_.status())) return round_.wrong("status");
        std::vector<Number> table(along_.x * along_.y);
        for (const auto& [page, frame] : pages_.frames()) table[page] = frame + 1;
        const auto start = [](std::vector<Number> all, std::size_t n) {
            all.resize(n);
            return all;
        };
        const auto& pages = grid_.pages();
        if (auto same = property::equal(round_, table, grid_.table().read(), "table"); !same) return same;
        if (auto same = property::equal(round_, order_, start(pages.active().read(), order_.size()), "pages"); !same)
            return same;
        if (auto same = property::equal(round_, granted_, start(pages.granted().read(), granted_.size()), "granted");
            !same)
            return same;
        return property::equal(round_, contents_, grid_.field().frames().read(), "frames");
    }

    testing::AssertionResult reads_are_right() {
        const std::vector<uint2> at = places(100);
        const bump::Values found(device_, static_cast<Number>(at.size()));
        bump::read_field(device_, on_device(at), grid_.field(), found);
        std::vector<Number> expected;
        for (uint2 place : at) {
            const Number* value = element(place);
            expected.push_back(value ? *value : unmapped);
        }
        return property::equal(round_, expected, found.read(), "find");
    }

    glift::Device device_;
    Round& round_;
    model::Overflow policy_;
    uint2 extent_, along_;
    Number capacity_;
    model::Pages pages_;
    Grid grid_;
    std::vector<Number> order_, granted_;  ///< resident pages in the order of their frames; those just granted
    std::vector<Number> contents_ = std::vector<Number>(capacity_ * page_volume);  ///< of all frames
};

TEST_P(Bump, Drop) {
    for_all("bump, drop", [&](Round& round) { Sequence<bump::Drop>(device(), round, model::Overflow::drop).run(); });
}

TEST_P(Bump, Fail) {
    for_all("bump, fail", [&](Round& round) { Sequence<bump::Fail>(device(), round, model::Overflow::fail).run(); });
}

TEST_P(Bump, Grow) {
    for_all("bump, grow", [&](Round& round) { Sequence<bump::Grow>(device(), round, model::Overflow::grow).run(); });
}

}  // namespace
