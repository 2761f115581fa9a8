// Compares merges with std::merge.
#include "chosen.h"
#include "input.h"

#include "merges.glift.hpp"

#include <algorithm>

namespace {

using namespace property;
using forms::Part;
using merges::Item;
using merges::Line;
using Uints = Input<Line, merges::Folded, merges::Folded, Line>;

GLIFT_PROPERTY_SUITE(Merges);

/// The expected output: `merged`, cut to the output's size; elements after it keep their values from `before`.
template <class T> std::vector<T> fitted(std::vector<T> before, const std::vector<T>& merged) {
    std::copy_n(merged.begin(), std::min(merged.size(), before.size()), before.begin());
    return before;
}

TEST_P(Merges, Uints) {
    for_all("merge of uints", [&](Round& round) {
        round.only(round.form() == Form::folded || round.form() == Form::mapped ? Form::folded : Form::dense);
        const Placed placed(round, round.size());
        auto a = values_with_repeats<std::uint32_t>(round, placed.count);
        auto b = values_with_repeats<std::uint32_t>(round, round.size());
        std::ranges::sort(a);
        std::ranges::sort(b);
        round.about("and " + std::to_string(b.size()));
        const Uints in(device(), round, placed, a);
        const auto count = static_cast<std::uint32_t>(b.size());
        merges::Tiles second(device(), std::max(count, 1u));
        if (count) second.write(b);
        const auto before = arbitrary_values<std::uint32_t>(round, room_for(round, placed.count + count));
        Line to(device(), static_cast<std::uint32_t>(before.size()));
        const auto found = twice(round, [&] {
            to.write(before);
            merges::merge_uints(device(), in.form, in.dense, in.folded, placed.part<Part>(), in.length, second, count,
                                to);
            return to.read();
        });
        std::vector<std::uint32_t> merged;
        std::ranges::merge(a, b, std::back_inserter(merged));
        EXPECT_TRUE(equal(round, fitted(before, merged), found));
    });
}

TEST_P(Merges, StructsInAnOrderOfTheirOwn) {
    for_all("merge_by of structs, the largest first", [&](Round& round) {
        round.only(Form::dense);
        const Placed placed(round, round.size());
        const std::uint32_t count = round.size();
        round.about("and " + std::to_string(count));
        const auto precedes = [](const Item& x, const Item& y) { return x.key > y.key; };
        const auto items = [&](std::uint32_t size, std::uint32_t origin) {
            std::vector<Item> all;
            for (std::uint32_t key : values_with_repeats<std::uint32_t>(round, size)) all.push_back({key, origin++});
            std::ranges::stable_sort(all, precedes);
            return all;
        };
        const auto a = items(placed.count, 0), b = items(count, 0x80000000u);
        merges::Items first(device(), placed.extent), second(device(), std::max(count, 1u));
        first.write(placed.among(std::vector<Item>(placed.extent), a));
        if (count) second.write(b);
        Line length(device(), 1);
        length.write(std::vector<glift::uint>{placed.count});
        const std::vector<Item> before(room_for(round, placed.count + count), Item{7, 7});
        merges::Items to(device(), static_cast<std::uint32_t>(before.size()));
        to.write(before);
        merges::merge_items(device(), first, placed.part<Part>(), length, second, count, to);
        std::vector<Item> merged;
        std::ranges::merge(a, b, std::back_inserter(merged), precedes);
        EXPECT_TRUE(equal(round, fitted(before, merged), to.read()));
    });
}

TEST_P(Merges, Views) {
    for_all("merge_by of views, the largest first", [&](Round& round) {
        round.only(Form::strided);
        const Placed placed(round, round.size());
        auto a = values_with_repeats<std::uint32_t>(round, placed.count);
        auto b = values_with_repeats<std::uint32_t>(round, round.size());
        std::ranges::sort(a, std::greater());
        std::ranges::sort(b, std::greater());
        const auto count = static_cast<std::uint32_t>(b.size());
        round.about("and " + std::to_string(count));
        const Uints in(device(), round, placed, a);
        auto stored = arbitrary_values<std::uint32_t>(round, count + round.below(500) + 1);
        for (std::uint32_t i = 0; i < count; ++i) stored[i] = ~b[i];
        Line second(device(), static_cast<std::uint32_t>(stored.size())), length(device(), 1);
        second.write(stored);
        length.write(std::vector<glift::uint>{count});
        const auto before = arbitrary_values<std::uint32_t>(round, room_for(round, placed.count + count));
        merges::Folded to(device(), static_cast<std::uint32_t>(before.size()));
        const auto found = twice(round, [&] {
            to.write(before);
            merges::merge_views(device(), in.dense, in.step, placed.part<Part>(), in.length, second, length, to);
            return to.read();
        });
        std::vector<std::uint32_t> merged;
        std::ranges::merge(a, b, std::back_inserter(merged), std::greater());
        EXPECT_TRUE(equal(round, fitted(before, merged), found));
    });
}

}  // namespace
