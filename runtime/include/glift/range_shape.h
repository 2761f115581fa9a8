// The box of a range, and where the elements of its structure lie, with the structure's type erased: what a device of
// several ranks has to know of the ranges that a call visits.
#pragma once

#include <glift/pass.h>
#include <glift/range.h>

#include <concepts>

namespace glift::detail {

/// Where the elements of a structure lie in one buffer. `index` is null where that is not known.
struct ElementIndices {
    const void* structure = nullptr;
    /// The index of an element in `memory`; UINT64_MAX where the address leads nowhere.
    std::uint64_t (*index)(const void* structure, const Extent& address) = nullptr;
    Memory memory;
};

struct RangeShape {
    unsigned rank = 1;
    Extent origin{}, size{}, domain{};
    bool is_whole = true;
    std::uint32_t element_bytes = 0;
    ElementIndices indices;
};

template <class A> A address_of(const Extent& extent) {
    if constexpr (Axes<A>::count == 1) return extent[0];
    else {
        A address;
        for (unsigned i = 0; i < Axes<A>::count; ++i) address[i] = extent[i];
        return address;
    }
}

/// Structures whose elements lie in a buffer by maps that gliftc can compute on the host, if not as rows (HasRows); or
/// in several buffers, by the same maps (ElementIndices::memory is then empty).
template <class S>
concept HasIndices = requires(const S& s, typename S::Address a) {
    { s.index_of(a) } -> std::same_as<std::uint64_t>;
};

template <class S> Memory index_memory_of(const S& structure) {
    if constexpr (requires { structure.index_memory(); }) return structure.index_memory();
    else return Memory();
}

/// Structures that have rows (HasRows of structure.h).
template <class S>
concept HasRowMemory = requires(const S& s, typename S::Address a) {
    { s.place(a) } -> std::same_as<std::uint64_t>;
    { s.row_memory() } -> std::same_as<const Memory&>;
};

template <class S> ElementIndices indices_of(const S& structure) {
    if constexpr (HasRowMemory<S>)
        return {&structure,
                [](const void* s, const Extent& at) {
                    return static_cast<const S*>(s)->place(address_of<typename S::Address>(at));
                },
                structure.row_memory()};
    else if constexpr (HasIndices<S>)
        return {&structure,
                [](const void* s, const Extent& at) {
                    return static_cast<const S*>(s)->index_of(address_of<typename S::Address>(at));
                },
                index_memory_of(structure)};
    else return {};
}

template <class S> RangeShape shape_of(const Range<S>& range) {
    RangeShape shape{Axes<typename S::Address>::count,
                     extent_of(range.origin(), 0),
                     extent_of(range.size()),
                     extent_of(range->domain()),
                     range.is_whole(),
                     0,
                     indices_of(range.structure())};
    if constexpr (requires { sizeof(typename S::Element); }) shape.element_bytes = sizeof(typename S::Element);
    return shape;
}

template <class S> RangeShape shape_of(const void* range) { return shape_of(*static_cast<const Range<S>*>(range)); }

}  // namespace glift::detail
