// The elements that a call may touch of one structure, without the structure's type: what is compared where one memory
// is passed for several parameters.
#pragma once

#include <glift/api.h>
#include <glift/pass.h>
#include <glift/range.h>

#include <concepts>
#include <initializer_list>
#include <span>

namespace glift::detail {

/// Structures whose translator is affine and leads into a buffer: they say where an element lies.
template <class S>
concept HasPlaces = requires(const S& s, typename S::Address a) {
    { s.place(a) } -> std::same_as<std::uint64_t>;
};

/// What is asked of a structure of one type; the address of the table tells the types apart.
struct StructureTable {
    bool (*same_state)(const void* one, const void* other);
    std::uint64_t (*place)(const void* structure, const Extent& address);  ///< in elements; null: not HasPlaces
    std::uint32_t element_bytes;
};

template <class S> std::uint64_t place_in(const void* structure, const Extent& address) {
    using Address = typename S::Address;
    if constexpr (Axes<Address>::count == 1) return static_cast<const S*>(structure)->place(address[0]);
    else {
        Address a;
        for (unsigned i = 0; i < Axes<Address>::count; ++i) a[i] = address[i];
        return static_cast<const S*>(structure)->place(a);
    }
}

template <class S> inline constexpr StructureTable structure_table = [] {
    StructureTable table{[](const void* one, const void* other) {
                             return static_cast<const S*>(one)->same_state(*static_cast<const S*>(other));
                         },
                         nullptr, sizeof(typename S::Element)};
    if constexpr (HasPlaces<S>) table.place = &place_in<S>;
    return table;
}();

/// The range that a call gives to one parameter.
struct Footprint {
    template <class S> Footprint(const Range<S>& range)
        : structure(&range.structure()), table(&structure_table<S>),
          is_whole(range.is_whole()), box{S::type_name, Axes<typename S::Address>::count, extent_of(range.origin(), 0),
                                          extent_of(range.size()), extent_of(range->domain())} {}

    const void* structure;
    const StructureTable* table;
    bool is_whole;
    Box box;
};

/// Whether some memory stands for two bindings and is written. Cheap: every call of a kernel asks.
GLIFT_API bool is_shared(const Kernel& kernel, std::span<const Memory> memories);

/// What the parameters touch of the memories that they share. `footprints` are those of the structures that the kernel
/// takes, in its order; `visited` is the box of the first one that it visits. Throws aliased_memory where invocations
/// could meet.
GLIFT_API Sharing compare_footprints(const Kernel& kernel, std::span<const Memory> memories, const Box& visited,
                                     std::span<const Footprint> footprints);

}  // namespace glift::detail
