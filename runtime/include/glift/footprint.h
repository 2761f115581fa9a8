// Footprints: the ranges that a call gives to its parameters, with the structures' types erased. They are compared
// where one memory is passed for several parameters.
#pragma once

#include <glift/api.h>
#include <glift/pass.h>
#include <glift/range.h>

#include <concepts>
#include <initializer_list>
#include <span>

namespace glift::detail {

/// The structures that have rows (HasRows of structure.h): `place(a)` is the index of element a in its buffer.
template <class S>
concept HasPlaces = requires(const S& s, typename S::Address a) {
    { s.place(a) } -> std::same_as<std::uint64_t>;
};

/// Type-erased functions of a structure type. Each type has one table in a library, so that the table's address
/// identifies the type within a call.
struct StructureTable {
    bool (*same_state)(const void* one, const void* other);
    /// Index of an element in the buffer; null: not HasPlaces.
    std::uint64_t (*place)(const void* structure, const Extent& address);
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

template <class S> GLIFT_LOCAL inline constexpr StructureTable structure_table = [] {
    StructureTable table{[](const void* one, const void* other) {
                             return static_cast<const S*>(one)->same_state(*static_cast<const S*>(other));
                         },
                         nullptr, sizeof(typename S::Element)};
    if constexpr (HasPlaces<S>) table.place = &place_in<S>;
    return table;
}();

/// The range as a box in the structure's domain. Not inlined, since generated code has many calls of kernels.
template <class S> [[gnu::noinline]] Box box_of(const char* name, const Range<S>& range) {
    return {name, Axes<typename S::Address>::count, extent_of(range.origin(), 0), extent_of(range.size()),
            extent_of(range->domain())};
}

/// The range that a call gives to one parameter.
struct Footprint {
    /// For parameters that have no range to compare: values on the device, containers, and structures of which the
    /// kernel calls functions. Their bindings may reach all elements.
    Footprint() = default;
    template <class S> [[gnu::noinline]] Footprint(const Range<S>& range)
        : structure(&range.structure()), table(&structure_table<S>), is_whole(range.is_whole()),
          box(box_of(S::type_name, range)) {}

    const void* structure = nullptr;
    const StructureTable* table = nullptr;
    bool is_whole = true;
    Box box{};
};

/// Whether one memory (or images with texels in common) is bound twice and written through at least one of the
/// bindings. Cheap, since it runs at each call of a kernel.
GLIFT_API bool is_shared(const Kernel& kernel, std::span<const Memory> memories);

/// How the parameters overlap in the memories that they share. `footprints` are those of the parameters that are
/// structures or values on the device, in the kernel's order; `visited` is the box of the first range that the kernel
/// visits element by element (in a draw: vertex by vertex). Throws aliased_memory where it cannot be ruled out that
/// invocations race.
GLIFT_API Sharing compare_footprints(const Kernel& kernel, std::span<const Memory> memories, const Box& visited,
                                     std::span<const Footprint> footprints);

}  // namespace glift::detail
