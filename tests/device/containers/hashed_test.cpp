// Sparse arrays whose page table is a hash set of pages: random requests, releases, writes, refinements and reads, at
// both ends of the axes and in the middle. Each change is compared with std::unordered_map, for each policy of pools
// that are too small: status, contents, the order of frames and the layout of the hash map, which are the same on every
// run and device.
#include "property.h"

#include "hashed.glift.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace {

using glift::uint2;
using property::Round;
using Number = std::uint32_t;

GLIFT_PROPERTY_SUITE(SparseHashed);

constexpr Number background = 77, page_x = 4, page_y = 2, page_volume = page_x * page_y, unmapped = 0xffffffff;

Number hash(Number key) {
    const Number a = (key ^ key >> 16) * 0x7feb352d, b = (a ^ a >> 15) * 0x846ca68b;
    return b ^ b >> 16;
}

struct Hash {
    Number operator()(uint2 key) const { return hash(hash(key.x) ^ key.y); }
};

uint2 page_of(uint2 place) { return {place.x / page_x, place.y / page_y}; }
Number element_of(uint2 place) { return place.y % page_y * page_x + place.x % page_x; }
bool in_row_major_order(uint2 a, uint2 b) { return a.y != b.y ? a.y < b.y : a.x < b.x; }

enum class Policy : std::uint8_t { drop, fail, evict, grow };

template <class Sheet> constexpr Policy policy_of = Policy::drop;
template <> constexpr Policy policy_of<hashed::Strict> = Policy::fail;
template <> constexpr Policy policy_of<hashed::Evicting> = Policy::evict;
template <> constexpr Policy policy_of<hashed::Growing> = Policy::grow;

/// The model: resident pages with their contents.
class Model {
public:
    struct Status {
        Number requested = 0, granted = 0, refused = 0, resident = 0, capacity = 0;
        bool operator==(const Status&) const = default;
    };

    Model(Number capacity, Policy policy) : policy_(policy) { status_.capacity = capacity; }

    void request(uint2 page) { wanted_.push_back(page); }

    void release(uint2 page) { contents_.erase(page); }

    /// Allocates what was requested. Frames of released pages are freed, pages that stay keep their order, and new
    /// pages follow them.
    void allocate() {
        ++round_;
        std::ranges::sort(wanted_, in_row_major_order);
        wanted_.erase(std::ranges::unique(wanted_).begin(), wanted_.end());
        std::vector<uint2> missing;
        for (uint2 page : wanted_) {
            if (contents_.contains(page)) last_[page] = round_;
            else missing.push_back(page);
        }
        wanted_.clear();
        status_.requested = static_cast<Number>(missing.size());
        if (policy_ == Policy::evict) evict();
        std::erase_if(order_, [&](uint2 page) { return !contents_.contains(page); });
        const auto resident = static_cast<Number>(order_.size());
        const Number needed = resident + status_.requested;
        if (policy_ == Policy::grow && needed > status_.capacity)
            status_.capacity = std::max(needed, 2 * status_.capacity);
        const Number room = status_.capacity - resident;
        const bool fails = policy_ == Policy::fail && status_.requested > room;
        status_.granted = fails ? 0 : std::min(status_.requested, room);
        status_.refused = status_.requested - status_.granted;
        status_.resident = resident + status_.granted;
        for (Number i = 0; i < status_.granted; ++i) {
            order_.push_back(missing[i]);
            contents_[missing[i]].fill(background);
            last_[missing[i]] = round_;
        }
    }

    /// An element in the model; null if its page is not resident, or if it is at the last coordinate of an axis, which
    /// is outside.
    Number* element(uint2 place) {
        if (place.x == 0xffffffff || place.y == 0xffffffff) return nullptr;
        const auto at = contents_.find(page_of(place));
        return at == contents_.end() ? nullptr : &at->second[element_of(place)];
    }

    void refine(Number by) {
        for (uint2 page : order_)
            if (const auto at = contents_.find(page); at != contents_.end())
                for (Number i = 0; i < page_volume; ++i) at->second[i] += by + i;
    }

    /// The hash map: linear probing from each key's slot, in the order of the entries.
    std::vector<Number> index() const {
        const Number size = 2 * status_.capacity;
        std::vector<Number> places(size);
        for (Number number = 0; number < order_.size(); ++number) {
            Number place = Hash{}(order_[number]) % size;
            while (places[place]) place = (place + 1) % size;
            places[place] = ~number;
        }
        return places;
    }

    std::vector<Number> frames() const {
        std::vector<Number> all;
        for (uint2 page : order_) {
            const auto& frame = contents_.at(page);
            all.insert(all.end(), frame.begin(), frame.end());
        }
        return all;
    }

    const Status& status() const { return status_; }
    const std::vector<uint2>& order() const { return order_; }

private:
    /// Evicts as many pages as frames are missing: those that were requested longest ago, but none requested just now.
    void evict() {
        std::vector<uint2> all;
        for (const auto& [page, content] : contents_) all.push_back(page);
        std::ranges::sort(all, [&](uint2 a, uint2 b) {
            return last_.at(a) != last_.at(b) ? last_.at(a) < last_.at(b) : in_row_major_order(a, b);
        });
        const auto room = static_cast<Number>(status_.capacity - all.size());
        Number left = status_.requested - std::min(status_.requested, room);
        for (uint2 page : all) {
            if (left-- == 0 || last_.at(page) == round_) return;
            contents_.erase(page);
        }
    }

    Policy policy_;
    Status status_;
    Number round_ = 0;
    std::unordered_map<uint2, Number, Hash> last_;  ///< number of the change that last requested a page
    std::vector<uint2> wanted_, order_;             ///< order: pages that were resident at the last change
    std::unordered_map<uint2, std::array<Number, page_volume>, Hash> contents_;
};

template <class Sheet> class Sequence {
public:
    Sequence(const glift::Device& device, Round& round)
        : device_(device), round_(round), capacity_(1 + round.below(round.chance(3) ? 400 : 40)),
          model_(capacity_, policy_of<Sheet>), sheet_(device, capacity_, background) {
        round_.about(std::string(Sheet::type_name) + ", capacity " + std::to_string(capacity_));
    }

    void run() {
        for (int step = 0; step < 8 && !testing::Test::HasFailure(); ++step) {
            request();
            if (round_.chance(2)) release();
            sheet_.allocate(device_);
            model_.allocate();
            ASSERT_TRUE(layout_is_right(step));
            if (round_.chance(2)) refine();
            if (round_.chance(2)) write();
            if (round_.chance(3)) release();
            ASSERT_TRUE(reads_are_right());
        }
    }

private:
    /// Addresses in four small regions far apart.
    std::vector<uint2> places(Number most) {
        static constexpr uint2 middles[] = {{0, 0}, {4000000000u, 12}, {0u - 40, 0x80000000u}, {1u << 31, 0u - 3}};
        std::vector<uint2> made(1 + round_.below(most));
        const Number spread = 1 + round_.below(64);
        for (uint2& place : made) {
            const uint2 middle = middles[round_.below(std::size(middles))];
            place = {middle.x + round_.below(spread), middle.y + round_.below(spread)};
        }
        return made;
    }

    hashed::Places on_device(const std::vector<uint2>& all) {
        hashed::Places made(device_, static_cast<Number>(all.size()));
        made.write(all);
        return made;
    }

    /// Kernels request at most as many pages as the set of wanted pages holds: twice the capacity at the start. A list
    /// of pages that is requested by a pipeline may be longer if the pool grows.
    void request() {
        const bool is_long = policy_of<Sheet> == Policy::grow && round_.chance(2);
        std::vector<uint2> asked = places(is_long ? 5 * capacity_ : 2 * capacity_);
        if (!is_long && round_.chance(2)) {
            hashed::request(device_, on_device(asked), sheet_);
        } else {
            for (uint2& place : asked) place = page_of(place);
            hashed::request_pages(device_, on_device(asked), sheet_);
            for (uint2& place : asked) place = {place.x * page_x, place.y * page_y};
        }
        for (uint2 place : asked) model_.request(page_of(place));
    }

    void release() {
        const std::vector<uint2> asked = places(1 + capacity_ / 2);
        hashed::release(device_, on_device(asked), sheet_);
        for (uint2 place : asked) model_.release(page_of(place));
    }

    void refine() {
        const Number by = round_.below(1000000);
        hashed::refine(device_, sheet_.frames(), model_.status().resident, by);
        model_.refine(by);
    }

    void write() {
        std::vector<uint2> at = places(120);
        std::ranges::sort(at, in_row_major_order);
        at.erase(std::ranges::unique(at).begin(), at.end());
        std::vector<Number> values(at.size());
        for (Number& value : values) value = round_.below(1u << 31);
        hashed::Values given(device_, static_cast<Number>(values.size()));
        given.write(values);
        hashed::write_field(device_, on_device(at), given, sheet_.field());
        for (std::size_t i = 0; i < at.size(); ++i)
            if (Number* place = model_.element(at[i])) *place = values[i];
    }

    template <class T> static std::vector<T> start(std::vector<T> all, std::size_t n) {
        all.resize(n);
        return all;
    }

    testing::AssertionResult layout_is_right(int step) {
        const auto status = sheet_.status(device_);
        const Model::Status found{status.requested, status.granted, status.refused, status.resident, status.capacity};
        if (!(found == model_.status())) return round_.wrong("status after step " + std::to_string(step));
        const auto& map = sheet_.pages().map();
        const std::size_t n = model_.order().size();
        if (auto same = property::equal(round_, model_.order(), start(map.keys().read(), n), "pages"); !same)
            return same;
        if (auto same = property::equal(round_, model_.index(), map.index().read(), "index"); !same) return same;
        return property::equal(round_, model_.frames(), start(sheet_.frames().read(), n * page_volume), "frames");
    }

    testing::AssertionResult reads_are_right() {
        const std::vector<uint2> at = places(150);
        const hashed::Places asked = on_device(at);
        const hashed::Values read(device_, static_cast<Number>(at.size())),
            found(device_, static_cast<Number>(at.size()));
        hashed::read_field(device_, asked, sheet_.field(), read);
        hashed::find_field(device_, asked, sheet_.field(), found);
        std::vector<Number> expected_read, expected_found;
        for (uint2 place : at) {
            const Number* value = model_.element(place);
            expected_read.push_back(value ? *value : background);
            expected_found.push_back(value ? *value : unmapped);
        }
        if (auto same = property::equal(round_, expected_read, read.read(), "read"); !same) return same;
        return property::equal(round_, expected_found, found.read(), "find");
    }

    glift::Device device_;
    Round& round_;
    Number capacity_;
    Model model_;
    Sheet sheet_;
};

TEST_P(SparseHashed, KeepsWhatAMapKeeps) {
    for_all("sparse array over a hash", [&](Round& round) {
        switch (round.seed() % 4) {  // not a count of the rounds: the seed alone must repeat a round
        case 0: return Sequence<hashed::Sheet>(device(), round).run();
        case 1: return Sequence<hashed::Strict>(device(), round).run();
        case 2: return Sequence<hashed::Evicting>(device(), round).run();
        default: return Sequence<hashed::Growing>(device(), round).run();
        }
    });
}

/// A change is one submission, and nothing is read back. Each replay releases and requests the pages of that moment.
TEST_P(SparseHashed, RecordedOnce) {
    for_all("sparse array over a hash, recorded", [&](Round& round) {
        const Number capacity = 1 + round.below(200), most = 2 * capacity;
        hashed::Sheet sheet(device(), capacity, background);
        Model model(capacity, Policy::drop);
        hashed::Places places(device(), most);
        const auto step = device().record([&](const glift::Commands& commands) {
            hashed::release(commands, places, sheet);
            hashed::request(commands, places, sheet);
            sheet.allocate(commands);
        });
        for (int i = 0; i < 6 && !HasFailure(); ++i) {
            std::vector<uint2> asked(most);
            for (uint2& place : asked) place = {0u - 60 + round.below(120), round.below(40)};
            places.write(asked);
            device().wait();
            const glift::Statistics before = device().statistics();
            step.submit();
            EXPECT_LE(device().statistics().submissions - before.submissions, 1u);  // the host device has none
            EXPECT_EQ(device().statistics().waits - before.waits, 0u);
            for (uint2 place : asked) {
                model.release(page_of(place));
                model.request(page_of(place));
            }
            model.allocate();
            ASSERT_TRUE(property::equal(round, model.index(), sheet.pages().map().index().read(), "index"));
            ASSERT_EQ(sheet.status(device()).refused, model.status().refused);
        }
    });
}

}  // namespace
