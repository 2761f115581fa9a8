// Compares radix sorts with std::stable_sort.
#include "input.h"

#include "sorts.glift.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace {

using namespace property;
using forms::Part;
using sorts::Line;

GLIFT_PROPERTY_SUITE(Sorts);

/// The order of keys in std.radix_sort. Of floats, zeros of both signs are equal; NaN is equal to itself and comes
/// after infinity, in descending order before all others.
struct Precedes {
    bool descending = false;

    template <class T> bool operator()(T a, T b) const {
        if (descending) std::swap(a, b);
        if constexpr (std::is_floating_point_v<T>) {
            if (a != a || b != b) return a == a;
        }
        return a < b;
    }
};

/// Replaces every NaN by the same one.
template <class T> std::vector<T> plain(std::vector<T> keys) {
    if constexpr (std::is_floating_point_v<T>)
        for (T& x : keys)
            if (x != x) x = std::numeric_limits<T>::quiet_NaN();
    return keys;
}

template <class T> std::vector<T> keys_of(Round& round, std::uint32_t count) {
    std::vector<T> keys = values_with_repeats<T>(round, count);
    if constexpr (std::is_floating_point_v<T>) {
        // Arbitrary bits; or special values among the others; or the values as values_with_repeats makes them.
        const std::uint32_t kind = round.below(3);
        using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
        static constexpr T smallest = std::numeric_limits<T>::denorm_min();
        static constexpr T special[] = {T(0), -T(0), INFINITY, -INFINITY, NAN, smallest, -smallest, 1, -1};
        for (T& x : keys) {
            if (kind == 1) {
                x = std::bit_cast<T>(arbitrary<Bits>(round));
                // A device may change the bits of a NaN, so all NaNs get the same bits.
                if (x != x) x = NAN;
            }
            if (kind == 2 && round.chance(2)) x = special[round.below(std::size(special))];
        }
    } else if (round.chance(4)) {
        for (T& x : keys) x = round.chance(2) ? std::numeric_limits<T>::max() : std::numeric_limits<T>::min();
    } else if (sizeof(T) == 8 && round.chance(3)) {
        // Keys that differ in one 8-bit digit.
        const unsigned shift = 8 * round.below(8);
        for (T& x : keys) x = static_cast<T>(static_cast<std::uint64_t>(round.below(256)) << shift);
    }
    return keys;
}

Line length_of(const glift::Device& device, const Placed& placed) {
    Line length(device, 1);
    length.write(std::vector<glift::uint>{placed.count});
    return length;
}

TEST_P(Sorts, UintsFromAnImage) {
    using In = Input<Line, sorts::Folded, sorts::Folded, Line>;
    for_all("sort_into of uints", [&](Round& round) {
        round.only(Form::folded);
        const Placed placed(round, round.size());
        auto values = keys_of<std::uint32_t>(round, placed.count);
        const In in(device(), round, placed, values);
        Output<Line> out(device(), round, placed);
        const auto found = twice(round, [&] {
            return out.after(
                [&](const Line& to) { sorts::sort_uints(device(), in.folded, placed.part<Part>(), in.length, to); });
        });
        std::ranges::sort(values);
        EXPECT_TRUE(equal(round, out.expected(placed, values), found));
    });
}

/// Sorts keys without values in place, by a call of `sort(keys, part, length, descending)`, and checks the result.
template <class S, class Sort> void in_place(const glift::Device& device, Round& round, Sort sort) {
    using T = typename S::Element;
    round.only(Form::dense);
    const Placed placed(round, round.size());
    auto values = keys_of<T>(round, placed.count);
    const bool descending = round.chance(2);
    round.about(descending ? "descending" : "ascending");
    const Line length = length_of(device, placed);
    const Output<S> out(device, round, placed);
    S keys(device, placed.extent);
    const auto found = twice(round, [&] {
        keys.write(out.expected(placed, values));
        sort(keys, placed.part<Part>(), length, descending);
        return plain(keys.read());
    });
    std::ranges::stable_sort(values, Precedes{descending});
    EXPECT_TRUE(equal(round, plain(out.expected(placed, values)), found));
}

TEST_P(Sorts, Ints) {
    for_all("sort_by of ints", [&](Round& round) {
        in_place<sorts::Integers>(device(), round,
                                  [&](const sorts::Integers& keys, Part part, const Line& length, bool descending) {
                                      sorts::sort_ints(device(), keys, part, length, descending);
                                  });
    });
}

TEST_P(Sorts, Longs) {
    for_all("sort_by of int64", [&](Round& round) {
        in_place<sorts::Longs>(device(), round,
                               [&](const sorts::Longs& keys, Part part, const Line& length, bool descending) {
                                   sorts::sort_longs(device(), keys, part, length, descending);
                               });
    });
}

TEST_P(Sorts, Doubles) {
    if (!device().properties().float64) GTEST_SKIP() << "no 64-bit floats";
    for_all("sort_by of doubles", [&](Round& round) {
        in_place<sorts::Doubles>(device(), round,
                                 [&](const sorts::Doubles& keys, Part part, const Line& length, bool descending) {
                                     sorts::sort_doubles(device(), keys, part, length, descending);
                                 });
    });
}

/// Copies the elements to be sorted in place from `from` to the same part of `to`; `count` has their number.
template <class S> void overlay(const Part& part, const Line& count, const S& from, const S& to) {
    const glift::uint n = count.read()[0];
    if (n > 0) S(to).write(part.first, n, from.read(part.first, n));
}

/// Sorts keys with their positions as values, which show whether the sort is stable.
template <class In, class To, class Sort> void pairs(const glift::Device& device, Round& round, Form form, Sort sort) {
    using T = typename To::Element;
    round.only(form);
    const Placed placed(round, round.size());
    const auto keys = keys_of<T>(round, placed.count);
    const In in(device, round, placed, keys);
    const bool descending = round.chance(2);
    round.about(descending ? "descending" : "ascending");
    std::vector<std::uint32_t> places(placed.extent), order(placed.count);
    std::iota(places.begin(), places.end(), 0u);
    Line values(device, placed.extent);
    values.write(places);
    Output<To> out(device, round, placed);
    Output<Line> values_out(device, round, placed);
    std::vector<std::uint32_t> values_found;
    const auto found = twice(round, [&] {
        return plain(out.after([&](const To& to) {
            values_found = values_out.after(
                [&](Line& values_to) { sort(in, values, placed.part<Part>(), descending, to, values_to); });
        }));
    });
    std::iota(order.begin(), order.end(), 0u);
    const Precedes precedes{descending};
    std::ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) { return precedes(keys[a], keys[b]); });
    std::vector<T> expected;
    for (std::uint32_t& place : order) {
        expected.push_back(keys[place]);
        place += placed.first;
    }
    EXPECT_TRUE(equal(round, plain(out.expected(placed, expected)), found, "keys:"));
    EXPECT_TRUE(equal(round, values_out.expected(placed, order), values_found, "values:"));
}

TEST_P(Sorts, FloatPairs) {
    using In = Input<sorts::Reals, sorts::Reals, sorts::Reals, Line>;
    for_all("sort of pairs by floats", [&](Round& round) {
        pairs<In, sorts::Reals>(device(), round, Form::mapped,
                                [&](const In& in, const Line& values, Part part, bool descending,
                                    const sorts::Reals& to, const Line& values_to) {
                                    sorts::sort_float_pairs(device(), in.dense, values, part, in.length, descending, to,
                                                            values_to);
                                });
    });
}

TEST_P(Sorts, WidePairs) {
    using In = Input<sorts::Wides, sorts::Wides, sorts::Wides, Line>;
    for_all("sort_pairs_by of uint64", [&](Round& round) {
        pairs<In, sorts::Wides>(device(), round, Form::dense,
                                [&](const In& in, const Line& values, Part part, bool descending,
                                    const sorts::Wides& keys, Line& values_too) {
                                    overlay(part, in.length, in.dense, keys);
                                    overlay(part, in.length, values, values_too);
                                    sorts::sort_wide_pairs(device(), keys, values_too, part, in.length, descending);
                                });
    });
}

TEST_P(Sorts, DoublePairs) {
    if (!device().properties().float64) GTEST_SKIP() << "no 64-bit floats";
    using In = Input<sorts::Doubles, sorts::Doubles, sorts::Doubles, Line>;
    for_all("sort_pairs_by of doubles", [&](Round& round) {
        pairs<In, sorts::Doubles>(device(), round, Form::dense,
                                  [&](const In& in, const Line& values, Part part, bool descending,
                                      const sorts::Doubles& keys, Line& values_too) {
                                      overlay(part, in.length, in.dense, keys);
                                      overlay(part, in.length, values, values_too);
                                      sorts::sort_double_pairs(device(), keys, values_too, part, in.length, descending);
                                  });
    });
}

}  // namespace
