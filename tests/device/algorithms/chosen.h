// For tests of algorithms that write the elements they select to the start of a structure, and return their number.
#pragma once

#include "property.h"

#include <algorithm>

namespace property {

/// What an algorithm that selects has left: all elements of the output, also those that it must not change, and the
/// number that it returned.
template <class T> struct Found {
    std::vector<T> elements;
    std::uint32_t count = 0;
    bool operator==(const Found&) const = default;
};

template <class T> testing::AssertionResult start_with(const Round& round, const std::vector<T>& before,
                                                       const std::vector<T>& expected, const Found<T>& found,
                                                       const char* which = "") {
    std::vector<T> all = before;
    const std::size_t fits = std::min(expected.size(), all.size());
    std::copy_n(expected.begin(), fits, all.begin());
    if (found.count != expected.size())
        return round.wrong("count expected " + std::to_string(expected.size()) + ", found " +
                           std::to_string(found.count));
    return equal(round, all, found.elements, which);
}

/// The size of the output for `count` elements; now and then too small, so that the algorithm leaves elements out.
inline std::uint32_t room_for(Round& round, std::uint32_t count) {
    return std::max(round.chance(4) ? round.below(count + std::uint64_t{1}) : count + round.below(50), 1u);
}

/// A random limit, or 0, which no number is below, or UINT32_MAX, which all numbers but itself are below.
inline std::uint32_t limit_of(Round& round) {
    return round.chance(4) ? 0 : round.chance(4) ? UINT32_MAX : static_cast<std::uint32_t>(round.engine()());
}

/// Runs the algorithm twice, each time with `before` written to its output `to`; expects equal results, returns one.
template <class S, class T, class Run>
Found<T> run_twice(const glift::Device& device, const Round& round, S& to, const std::vector<T>& before, Run run) {
    const auto once = [&] {
        to.write(before);
        const std::uint32_t count = run().await(device);
        return Found<T>{to.read(), count};
    };
    Found<T> first = once();
    if (first != once()) ADD_FAILURE() << round.wrong("another result in another run").message();
    return first;
}

}  // namespace property
