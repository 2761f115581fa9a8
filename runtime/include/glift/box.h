// Virtual addresses and sizes as four numbers, and boxes of them.
#pragma once

#include <glift/error.h>
#include <glift/extent.h>
#include <glift/vector.h>

#include <algorithm>
#include <array>
#include <string>

namespace glift {

using Extent = std::array<std::uint32_t, 4>;

namespace detail {

template <class A> struct Axes {
    static constexpr unsigned count = 1;
    static constexpr std::uint32_t at(A a, unsigned) { return a; }
};
template <unsigned N> struct Axes<vec<uint, N>> {
    static constexpr unsigned count = N;
    static constexpr std::uint32_t at(const vec<uint, N>& a, unsigned i) { return a[i]; }
};

/// A virtual address or size as four numbers; axes that it does not have are `rest`.
template <class A> constexpr Extent extent_of(const A& a, std::uint32_t rest = 1) {
    Extent extent;
    for (unsigned i = 0; i < 4; ++i) extent[i] = i < Axes<A>::count ? Axes<A>::at(a, i) : rest;
    return extent;
}

/// Elements of a box; 2^64 - 1 where there are more.
constexpr std::uint64_t volume_of(const Extent& extent) {
    if (std::ranges::find(extent, 0u) != extent.end()) return 0;
    std::uint64_t volume = 1;
    for (std::uint32_t part : extent) volume = saturated_product(volume, part);
    return volume;
}

inline std::string text_of(const Extent& extent, unsigned rank) {
    std::string text = "{";
    for (unsigned i = 0; i < rank; ++i) text += (i ? ", " : "") + std::to_string(extent[i]);
    return text + "}";
}

/// A box as the checks see it.
struct Box {
    const char* name;
    unsigned rank;
    Extent origin, size, domain;

    /// Of boxes of one domain.
    bool meets(const Box& other) const {
        for (unsigned i = 0; i < rank; ++i) {
            if (std::uint64_t{origin[i]} + size[i] <= other.origin[i]) return false;
            if (std::uint64_t{other.origin[i]} + other.size[i] <= origin[i]) return false;
        }
        return volume_of(size) != 0 && volume_of(other.size) != 0;
    }
    bool is_inside() const {
        for (unsigned i = 0; i < rank; ++i) {
            if (size[i] > domain[i] || origin[i] > domain[i] - size[i]) return false;
        }
        return true;
    }
};

[[noreturn]] inline void throw_outside(const std::string& where, const Box& box) {
    throw Error(ErrorCode::wrong_argument, std::string("a box of ") + box.name + " lies outside its domain", where,
                box.name + (" starts at " + text_of(box.origin, box.rank)) + " and is " + text_of(box.size, box.rank) +
                    " large, the domain is " + text_of(box.domain, box.rank),
                "pass a box inside the domain");
}

[[noreturn]] inline void throw_outside_range(const char* name, const Box& box) {
    throw Error(ErrorCode::wrong_argument,
                std::string("a box lies outside the range of ") + name + " that it is taken from",
                std::string(name) + "::range",
                "it starts at " + text_of(box.origin, box.rank) + " and is " + text_of(box.size, box.rank) +
                    " large, the range is " + text_of(box.domain, box.rank),
                "pass a box inside the range; its addresses count from the range's origin");
}

[[noreturn]] inline void throw_slice(const char* place, unsigned rank, const Extent& first, const Extent& last,
                                     const Extent& whole) {
    bool ends_first = false;
    for (unsigned axis = 0; axis < rank; ++axis) ends_first = ends_first || last[axis] < first[axis];
    throw Error(ErrorCode::wrong_argument,
                ends_first ? "a slice ends before it begins" : "a slice lies outside what it is taken from", place,
                "it goes from " + text_of(first, rank) + " to before " + text_of(last, rank) +
                    ", and there are elements from 0 to before " + text_of(whole, rank),
                "slice as a[first .. last], with first <= last and last no larger than the extent");
}

/// For structures that were default-made or moved from.
[[noreturn]] inline void throw_empty_structure(const char* type, const char* operation) {
    throw Error(ErrorCode::wrong_argument, std::string("an empty ") + type + " was used",
                std::string(type) + "::" + operation, "it was default-made, or moved from",
                std::string("make it with a device first: ") + type + "(device, ...)");
}

}  // namespace detail

}  // namespace glift
