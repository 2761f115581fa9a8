// Compares algorithms, most of them over a user-defined struct and with user-defined functions, with the C++ library's
// and with plain loops.
#include "chosen.h"
#include "input.h"

#include "items.glift.hpp"

#include <algorithm>
#include <numeric>

/// `mirrored` of items.glift on the host.
template <> items::Item property::mirrored(items::Item x) { return {~x.key, ~x.weight, ~x.tag}; }

namespace {

using namespace property;
using forms::Part;
using items::Item;
using items::Line;
using Values = std::vector<Item>;
using Numbers = std::vector<std::uint32_t>;
using In = Input<items::Items, items::Items, items::TiledItems, Line>;

GLIFT_PROPERTY_SUITE(Items);

/// Items whose keys and weights come from values_with_repeats; tags count up.
Values items_of(Round& round, std::uint32_t count) {
    const auto keys = values_with_repeats<std::uint32_t>(round, count);
    const auto weights = values_with_repeats<std::int32_t>(round, count);
    Values values(count);
    for (std::uint32_t i = 0; i < count; ++i) values[i] = {keys[i], weights[i], i};
    return values;
}

/// The key of one of the items, or now and then another limit, such as one that all or none are below.
std::uint32_t limit_among(Round& round, const Values& values) {
    return values.empty() || round.chance(8) ? limit_of(round) : values[round.below(values.size())].key;
}

bool same_key(const Item& a, const Item& b) { return a.key == b.key; }

TEST_P(Items, Compact) {
    for_all("compact of structs in tiles", [&](Round& round) {
        round.only(Form::tiled);
        const Placed placed(round, round.size());
        const Values values = items_of(round, placed.count);
        const std::uint32_t limit = limit_among(round, values);
        const In in(device(), round, placed, values);
        const Values before = arbitrary_values<Item>(round, room_for(round, placed.count));
        items::Items to(device(), static_cast<std::uint32_t>(before.size()));
        const auto found = run_twice(device(), round, to, before, [&] {
            return items::chosen(device(), in.tiled, placed.part<Part>(), in.length, limit, to);
        });
        Values expected;
        std::ranges::copy_if(values, std::back_inserter(expected), [&](const Item& x) { return x.key < limit; });
        EXPECT_TRUE(start_with(round, before, expected, found));
    });
}

TEST_P(Items, CompactFlagged) {
    using Folded = Input<Line, items::Folded, items::Tiles, Line>;
    for_all("compact_flagged from an image, with flags in tiles", [&](Round& round) {
        round.only(Form::folded);
        const Placed placed(round, round.size());
        const auto values = arbitrary_values<std::uint32_t>(round, placed.count);
        const Folded in(device(), round, placed, values);
        // Now and then there are fewer flags than elements.
        Numbers flags(std::max(round.chance(3) ? round.below(placed.count) : placed.count, 1u));
        for (std::uint32_t& flag : flags) flag = round.chance(2) ? 0 : arbitrary<std::uint32_t>(round);
        const auto count = std::min(static_cast<std::uint32_t>(flags.size()), placed.count);
        items::Tiles keep(device(), static_cast<std::uint32_t>(flags.size()));
        keep.write(flags);
        const Numbers before = arbitrary_values<std::uint32_t>(round, room_for(round, placed.count));
        Line to(device(), static_cast<std::uint32_t>(before.size()));
        const auto found = run_twice(device(), round, to, before, [&] {
            return items::flagged(device(), in.folded, placed.part<Part>(), in.length, keep, count, to);
        });
        Numbers expected;
        for (std::uint32_t i = 0; i < count; ++i)
            if (flags[i]) expected.push_back(values[i]);
        EXPECT_TRUE(start_with(round, before, expected, found));
    });
}

TEST_P(Items, Partition) {
    for_all("partition of structs to tiles", [&](Round& round) {
        round.only(Form::mapped);
        const Placed placed(round, round.size());
        Values values = items_of(round, placed.count);
        const std::uint32_t limit = limit_among(round, values);
        const In in(device(), round, placed, values);
        const Values before = arbitrary_values<Item>(round, room_for(round, placed.count));
        items::TiledItems to(device(), static_cast<std::uint32_t>(before.size()));
        auto found = run_twice(device(), round, to, before, [&] {
            return items::set_apart(device(), in.dense, placed.part<Part>(), in.length, limit, to);
        });
        const auto middle =
            std::stable_partition(values.begin(), values.end(), [&](const Item& x) { return x.key < limit; });
        EXPECT_TRUE(
            equal(round, {static_cast<std::uint32_t>(middle - values.begin())}, Numbers{found.count}, "count:"));
        found.count = placed.count;
        EXPECT_TRUE(start_with(round, before, values, found));
    });
}

TEST_P(Items, Unique) {
    for_all("unique_by of structs", [&](Round& round) {
        round.only(Form::strided);
        const Placed placed(round, round.size());
        const Values values = items_of(round, placed.count);
        const In in(device(), round, placed, values);
        const Values before = arbitrary_values<Item>(round, room_for(round, placed.count));
        items::Items to(device(), static_cast<std::uint32_t>(before.size()));
        const auto found = run_twice(device(), round, to, before, [&] {
            return items::different_keys(device(), in.dense, in.step, placed.part<Part>(), in.length, to);
        });
        Values expected;
        std::ranges::unique_copy(values, std::back_inserter(expected), same_key);
        EXPECT_TRUE(start_with(round, before, expected, found));
    });
}

TEST_P(Items, UniquePairs) {
    using Pairs = Input<items::Pairs, items::FoldedPairs, items::Pairs, Line>;
    for_all("unique of uint2 from an image", [&](Round& round) {
        round.only(Form::folded);
        const Placed placed(round, round.size());
        const auto low = values_with_repeats<std::uint32_t>(round, placed.count);
        const auto high = values_with_repeats<std::uint32_t>(round, placed.count);
        std::vector<glift::uint2> values;
        for (std::uint32_t i = 0; i < placed.count; ++i) values.push_back({low[i], high[i]});
        const Pairs in(device(), round, placed, values);
        const auto before = arbitrary_values<glift::uint2>(round, room_for(round, placed.count));
        items::Pairs to(device(), static_cast<std::uint32_t>(before.size()));
        const auto found = run_twice(device(), round, to, before, [&] {
            return items::different_pairs(device(), in.folded, placed.part<Part>(), in.length, to);
        });
        std::vector<glift::uint2> expected;
        std::ranges::unique_copy(values, std::back_inserter(expected));
        EXPECT_TRUE(start_with(round, before, expected, found));
    });
}

TEST_P(Items, RunLengths) {
    for_all("run_lengths_by of structs", [&](Round& round) {
        round.only(Form::mapped);
        const Placed placed(round, round.size());
        const Values values = items_of(round, placed.count);
        const In in(device(), round, placed, values);
        const Values before = arbitrary_values<Item>(round, room_for(round, placed.count));
        const auto room = static_cast<std::uint32_t>(before.size());
        const Numbers lengths_before = arbitrary_values<std::uint32_t>(round, room);
        items::Items to(device(), room);
        items::Folded lengths(device(), room);
        lengths.write(lengths_before);
        const auto found = run_twice(device(), round, to, before, [&] {
            return items::runs_of_keys(device(), in.dense, placed.part<Part>(), in.length, to, lengths);
        });
        Values expected;
        Numbers expected_lengths;
        for (const Item& item : values) {
            if (expected.empty() || item.key != expected.back().key) {
                expected.push_back(item);
                expected_lengths.push_back(0);
            }
            ++expected_lengths.back();
        }
        EXPECT_TRUE(start_with(round, before, expected, found, "values:"));
        EXPECT_TRUE(start_with(round, lengths_before, expected_lengths,
                               Found<std::uint32_t>{lengths.read(), found.count}, "lengths:"));
    });
}

TEST_P(Items, Sort) {
    for_all("sort_by of structs by a user's order", [&](Round& round) {
        round.only(Form::dense);
        const Placed placed(round, round.size());
        Values values = items_of(round, placed.count);
        const bool descending = round.chance(2);
        round.about(descending ? "descending" : "ascending");
        Line length(device(), 1);
        length.write(Numbers{placed.count});
        const Output<items::Items> out(device(), round, placed);
        items::Items all(device(), placed.extent);
        const auto found = twice(round, [&] {
            all.write(out.expected(placed, values));
            items::sort_items(device(), all, placed.part<Part>(), length, descending);
            return all.read();
        });
        std::ranges::stable_sort(values, [&](const Item& a, const Item& b) {
            return descending ? b.weight < a.weight : a.weight < b.weight;
        });
        EXPECT_TRUE(equal(round, out.expected(placed, values), found));
    });
}

TEST_P(Items, SortBeside) {
    using Keys = Input<Line, items::Folded, items::Tiles, Line>;
    for_all("sort_pairs_into, structs by keys of a view", [&](Round& round) {
        round.only(Form::strided);
        const Placed placed(round, round.size());
        const Values values = items_of(round, placed.count);
        Numbers keys;
        for (const Item& item : values) keys.push_back(item.key);
        const Keys in(device(), round, placed, keys);
        items::TiledItems beside(device(), placed.extent);
        beside.write(placed.among(Values(placed.extent), values));
        Output<Line> keys_out(device(), round, placed);
        Output<items::Items> out(device(), round, placed);
        Numbers keys_found;
        const auto found = twice(round, [&] {
            return out.after([&](const items::Items& to) {
                keys_found = keys_out.after([&](const Line& keys_to) {
                    items::sort_beside(device(), in.dense, in.step, beside, placed.part<Part>(), in.length, keys_to,
                                       to);
                });
            });
        });
        Values expected = values;
        std::ranges::stable_sort(expected, {}, &Item::key);
        std::ranges::sort(keys);
        EXPECT_TRUE(equal(round, keys_out.expected(placed, keys), keys_found, "keys:"));
        EXPECT_TRUE(equal(round, out.expected(placed, expected), found, "items:"));
    });
}

TEST_P(Items, Gather) {
    using Indices = Input<Line, items::Folded, items::Tiles, Line>;
    for_all("gather of structs, by indices of a view", [&](Round& round) {
        round.only(Form::mapped);
        const Placed placed(round, round.size());
        const Values values = items_of(round, std::max(round.size(), 1u));
        const auto count = static_cast<std::uint32_t>(values.size());
        items::TiledItems from(device(), count);
        from.write(values);
        Numbers places(placed.count);
        Values expected;
        for (std::uint32_t& place : places) {
            // Some indices are just beyond the end, a few far beyond.
            place = round.chance(100) ? UINT32_MAX - round.below(3) : round.below(count + std::uint64_t{3});
            expected.push_back(place < count ? values[place] : Item{});
        }
        const Indices in(device(), round, placed, places);
        Output<items::Items> out(device(), round, placed);
        const auto found = out.after([&](const items::Items& to) {
            items::gathered(device(), from, in.dense, placed.part<Part>(), in.length, to);
        });
        EXPECT_TRUE(equal(round, out.expected(placed, expected), found));
    });
}

TEST_P(Items, Scatter) {
    for_all("scatter of structs, by indices in tiles", [&](Round& round) {
        round.only(Form::strided);
        const Placed placed(round, round.size());
        const Values values = items_of(round, placed.count);
        const In in(device(), round, placed, values);
        // Each index occurs at most once; some are out of range.
        const std::uint32_t room = std::max(placed.count + round.below(100), 1u);
        Numbers places(std::max(placed.extent, room + 5));
        std::iota(places.begin(), places.end(), 0u);
        std::shuffle(places.begin(), places.end(), round.engine());
        places.resize(placed.extent);
        items::Tiles indices(device(), placed.extent);
        indices.write(places);
        Values expected = arbitrary_values<Item>(round, room);
        items::Items to(device(), room);
        to.write(expected);
        items::scattered(device(), in.dense, in.step, placed.part<Part>(), in.length, indices, to);
        for (std::uint32_t i = 0; i < placed.count; ++i) {
            const std::uint32_t place = places[placed.first + i];
            if (place < room) expected[place] = values[i];
        }
        EXPECT_TRUE(equal(round, expected, to.read()));
    });
}

TEST_P(Items, Moved) {
    for_all("copy, transform_in_place, reverse of structs", [&](Round& round) {
        round.only(Form::tiled);
        const Placed placed(round, round.size());
        Values values = items_of(round, placed.count), own = items_of(round, placed.count);
        const auto more = static_cast<std::int32_t>(round.below(1000));
        const In in(device(), round, placed, values);
        Output<items::Items> copied(device(), round, placed), turned(device(), round, placed);
        items::TiledItems changed(device(), placed.extent);
        Values all = placed.among(arbitrary_values<Item>(round, placed.extent), own);
        changed.write(all);
        Values turned_found;
        const Values copied_found = copied.after([&](const items::Items& copied_to) {
            turned_found = turned.after([&](const items::Items& turned_to) {
                items::moved(device(), in.tiled, placed.part<Part>(), in.length, more, copied_to, changed, turned_to);
            });
        });
        for (Item& x : own) x.weight = static_cast<std::int32_t>(static_cast<std::uint32_t>(x.weight) + more);
        EXPECT_TRUE(equal(round, placed.among(all, own), changed.read(), "changed:"));
        EXPECT_TRUE(equal(round, copied.expected(placed, values), copied_found, "copied:"));
        std::ranges::reverse(values);
        EXPECT_TRUE(equal(round, turned.expected(placed, values), turned_found, "turned:"));
    });
}

TEST_P(Items, Find) {
    for_all("find_if of structs", [&](Round& round) {
        round.only(Form::mapped);
        const Placed placed(round, round.size());
        Values values = items_of(round, placed.count);
        // The first match may be anywhere, or nowhere.
        const std::uint32_t limit = 1 + round.below(1000);
        for (Item& x : values) x.key = round.chance(1 + placed.count) ? round.below(limit) : std::max(x.key, limit);
        const In in(device(), round, placed, values);
        const auto found = items::where_is(device(), in.dense, placed.part<Part>(), in.length, limit).await(device());
        const auto at = std::ranges::find_if(values, [&](const Item& x) { return x.key < limit; }) - values.begin();
        EXPECT_TRUE(equal(round, {static_cast<std::uint32_t>(at)}, Numbers{found}));
    });
}

TEST_P(Items, Equal) {
    for_all("equal_if of structs, both lengths on the device", [&](Round& round) {
        round.only(Form::tiled);
        const Placed placed(round, round.size());
        const Values values = items_of(round, placed.count);
        const In in(device(), round, placed, values);
        Values other = values;
        for (Item& x : other) x.tag = x.weight = 7;
        if (round.chance(4)) other.push_back({});
        else if (!other.empty() && round.chance(4)) other.pop_back();
        if (!other.empty() && round.chance(2)) other[round.below(other.size())].key ^= 1u << round.below(32);
        const auto count = static_cast<std::uint32_t>(other.size());
        const std::uint32_t step = 1 + round.below(4);
        Values spread = arbitrary_values<Item>(round, (count + round.below(9) + 1) * step);
        for (std::uint32_t i = 0; i < count; ++i) spread[i * step] = other[i];
        items::Items b(device(), static_cast<std::uint32_t>(spread.size()));
        b.write(spread);
        Line length(device(), 1);
        length.write(Numbers{count});
        const auto found =
            items::have_same_keys(device(), in.tiled, placed.part<Part>(), in.length, b, step, length).await(device());
        EXPECT_TRUE(equal(round, {std::ranges::equal(values, other, same_key) ? 1u : 0u}, Numbers{found}));
    });
}

}  // namespace
