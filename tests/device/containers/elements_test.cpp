// Algorithms over the elements of listed pages, compared with the C++ library's over the same values. Pages have a
// frame, none, or one that the pool does not have; some reach beyond the field.
#include "property.h"

#include "elements.glift.hpp"

#include <algorithm>
#include <numeric>

namespace {

using glift::uint2;
using property::Round;
using Number = std::uint32_t;
using Numbers = std::vector<Number>;

GLIFT_PROPERTY_SUITE(Elements);

constexpr Number background = 5, page_volume = 8, page_x = 4, page_y = 2;

/// A field; a page table most of whose entries name a frame, in random order, some beyond the pool; and a list of some
/// of the field's pages, each once.
class Sheet {
public:
    Sheet(const glift::Device& device, Round& round)
        : extent_{1 + round.below(70), 1 + round.below(50)}, along_{(extent_.x + page_x - 1) / page_x,
                                                                    (extent_.y + page_y - 1) / page_y},
          pages_(along_.x * along_.y), capacity_(1 + round.below(pages_)), listed_(1 + round.below(pages_)),
          table_(device, pages_), list_(device, listed_), field_(device, table_, extent_, capacity_, background),
          all(device, field_, list_), n(device, 1) {
        round.about("extent " + std::to_string(extent_.x) + " x " + std::to_string(extent_.y) + ", capacity " +
                    std::to_string(capacity_) + ", pages listed " + std::to_string(listed_));
        Numbers frames(pages_), order(pages_);
        std::iota(frames.begin(), frames.end(), 0u);
        std::iota(order.begin(), order.end(), 0u);
        std::ranges::shuffle(frames, round.engine());
        std::ranges::shuffle(order, round.engine());
        for (Number& frame : frames) frame = round.chance(4) ? 0 : frame + 1;
        order.resize(listed_);
        table_.write(frames);
        list_.write(order);
        Numbers contents(std::size_t{capacity_} * page_volume);
        const Number spread = round.chance(2) ? 3 : 1000;
        for (std::size_t i = 0; i < contents.size(); ++i) contents[i] = i % 3 ? contents[i - 1] : round.below(spread);
        field_.frames().write(contents);
        const Number count = round.chance(3) ? listed_ * page_volume : round.below(listed_ * page_volume + 1);
        n.write(Numbers{count});
        for (Number k = 0; k < listed_ * page_volume; ++k) {
            const Number page = order[k / page_volume], i = k % page_volume, frame = frames[page];
            const uint2 at{page % along_.x * page_x + i % page_x, page / along_.x * page_y + i / page_x};
            is_there.push_back(at.x < extent_.x && at.y < extent_.y && frame != 0 && frame <= capacity_);
            all_values.push_back(is_there.back() ? contents[(frame - 1) * page_volume + i] : background);
        }
        values.assign(all_values.begin(), all_values.begin() + count);
    }

private:
    uint2 extent_, along_;
    Number pages_, capacity_, listed_;
    elements::Values table_, list_;
    elements::Field field_;

public:
    elements::Listed all;
    elements::Values n;          ///< one element: how many elements of `all` a test takes
    Numbers all_values, values;  ///< the values of all elements of `all`; of the first n
    std::vector<bool> is_there;  ///< whether each element of `all` is resident and in the domain

    elements::Values made(const glift::Device& device) const {
        return {device, static_cast<Number>(all_values.size())};
    }
    Numbers start_of(const elements::Values& found, std::size_t count) const {
        Numbers numbers = found.read();
        numbers.resize(count);
        return numbers;
    }
};

TEST_P(Elements, ScannedAndChosen) {
    for_all("scan, compact, unique", [&](Round& round) {
        const Sheet sheet(device(), round);
        const elements::Values to = sheet.made(device());
        Numbers expected(sheet.values.size());
        std::partial_sum(sheet.values.begin(), sheet.values.end(), expected.begin());
        elements::scanned(device(), sheet.all, sheet.n, to);
        ASSERT_TRUE(property::equal(round, expected, sheet.start_of(to, expected.size()), "scan"));
        const Number limit = round.below(1000);
        expected.clear();
        std::ranges::copy_if(sheet.values, std::back_inserter(expected), [&](Number x) { return x < limit; });
        ASSERT_EQ(elements::chosen(device(), sheet.all, sheet.n, limit, to).await(device()), expected.size());
        ASSERT_TRUE(property::equal(round, expected, sheet.start_of(to, expected.size()), "compact"));
        expected.clear();
        std::ranges::unique_copy(sheet.values, std::back_inserter(expected));
        ASSERT_EQ(elements::without_repeats(device(), sheet.all, sheet.n, to).await(device()), expected.size());
        ASSERT_TRUE(property::equal(round, expected, sheet.start_of(to, expected.size()), "unique"));
    });
}

TEST_P(Elements, CountedAndFound) {
    for_all("histogram, find, min_element, reduce, equal", [&](Round& round) {
        const Sheet sheet(device(), round);
        elements::Values bins(device(), 1 + round.below(600));
        Numbers expected(bins.extent());
        for (Number x : sheet.values)
            if (x < expected.size()) ++expected[x];
        elements::counted(device(), sheet.all, sheet.n, bins);
        ASSERT_TRUE(property::equal(round, expected, bins.read(), "histogram"));
        const Number wanted = round.below(10);
        const auto place = static_cast<Number>(std::ranges::find(sheet.values, wanted) - sheet.values.begin());
        ASSERT_EQ(elements::place_of(device(), sheet.all, sheet.n, wanted).await(device()), place);
        const Number least = elements::place_of_least(device(), sheet.all, sheet.n).await(device());
        if (!sheet.values.empty()) {
            ASSERT_EQ(least, std::ranges::min_element(sheet.values) - sheet.values.begin());
        }
        ASSERT_EQ(elements::total(device(), sheet.all, sheet.n).await(device()),
                  std::accumulate(sheet.values.begin(), sheet.values.end(), 0u));
        elements::Values same = sheet.made(device());
        same.write(sheet.all_values);
        ASSERT_EQ(elements::are_equal(device(), sheet.all, same).await(device()), 1u);
        Numbers other = sheet.all_values;
        ++other[round.below(other.size())];
        same.write(other);
        ASSERT_EQ(elements::are_equal(device(), sheet.all, same).await(device()), 0u);
    });
}

TEST_P(Elements, Moved) {
    for_all("copy, gather, reverse", [&](Round& round) {
        Sheet sheet(device(), round);
        elements::Values to = sheet.made(device()), places = sheet.made(device());
        elements::copied(device(), sheet.all, sheet.n, to);
        ASSERT_TRUE(property::equal(round, sheet.values, sheet.start_of(to, sheet.values.size()), "copy"));
        Numbers from(sheet.all_values.size()), expected;
        for (Number& place : from) place = round.below(from.size());
        places.write(from);
        for (Number place : from) expected.push_back(sheet.all_values[place]);
        elements::gathered(device(), sheet.all, places, to);
        ASSERT_TRUE(property::equal(round, expected, to.read(), "gather"));
        elements::turned(device(), sheet.all, to);
        expected.assign(sheet.all_values.rbegin(), sheet.all_values.rend());
        ASSERT_TRUE(property::equal(round, expected, to.read(), "reverse"));
        // Elements that are not resident, or outside the domain, are not written: they still read as the background.
        elements::numbered(device(), sheet.all, places);
        for (std::size_t i = 0; i < from.size(); ++i) expected[i] = sheet.is_there[i] ? from[i] : background;
        ASSERT_TRUE(property::equal(round, expected, sheet.all.read(), "written"));
    });
}

}  // namespace
