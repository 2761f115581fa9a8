// Virtual addresses and sizes of one to four axes, padded to four numbers, and boxes of addresses.
#pragma once

#include <glift/api.h>
#include <glift/error.h>
#include <glift/extent.h>
#include <glift/vector.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
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

/// A virtual address or size padded to four numbers with `rest`.
template <class A> constexpr Extent extent_of(const A& a, std::uint32_t rest = 1) {
    Extent extent;
    for (unsigned i = 0; i < 4; ++i) extent[i] = i < Axes<A>::count ? Axes<A>::at(a, i) : rest;
    return extent;
}

/// The number of elements of a box of this size; saturates at 2^64 - 1.
constexpr std::uint64_t volume_of(const Extent& extent) {
    if (std::ranges::find(extent, 0u) != extent.end()) return 0;
    std::uint64_t volume = 1;
    for (std::uint32_t part : extent) volume = saturated_product(volume, part);
    return volume;
}

GLIFT_API std::string text_of(const Extent& extent, unsigned rank);

/// A box of addresses, for checks of bounds and overlap. `name`, for messages: the structure's type or the kernel's
/// parameter. `domain`: the extent of what the box must lie in: a structure's domain, a range or a mapped box. From
/// `rank` on, origins are 0 and sizes 1.
struct Box {
    const char* name;
    unsigned rank;
    Extent origin, size, domain;

    /// Whether two boxes of one domain share an element.
    bool overlaps(const Box& other) const {
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

// Functions that throw an Error. They are not inline, since generated code has many calls of them.

[[noreturn]] GLIFT_API void throw_outside(const std::string& where, const Box& box);
/// Error::where is `type::operation`.
[[noreturn]] GLIFT_API void throw_outside(const char* type, const char* operation, const Box& box);
[[noreturn]] GLIFT_API void throw_outside_range(const char* name, const Box& box);
[[noreturn]] GLIFT_API void throw_outside_mapped(const Box& box);
[[noreturn]] GLIFT_API void throw_slice(const char* place, unsigned rank, const Extent& first, const Extent& last,
                                        const Extent& whole);
/// Throws the error for a number of values that is not the number of elements of the box.
[[noreturn]] GLIFT_API void throw_count(const char* type, std::size_t given, const Extent& size, unsigned rank);
[[noreturn]] GLIFT_API void throw_other_part(const char* name);
/// A list of values whose type is erased.
struct ValueList {
    void* values;
    void (*resize)(void* values, std::size_t count);
};
/// Gives the list one value per element of a box that is read. Throws out_of_memory.
GLIFT_API void make_values(const char* type, unsigned rank, const Extent& size, std::size_t element_bytes,
                           const ValueList& list);
/// Throws the error for a structure that was default-constructed or moved from.
[[noreturn]] GLIFT_API void throw_empty_structure(const char* type, const char* operation);

}  // namespace detail

}  // namespace glift
