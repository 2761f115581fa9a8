// Random boxes of two-dimensional structures, for tests of algorithms over rows or columns ("systems"): tridiagonal
// systems and filters.
#pragma once

#include "property.h"

namespace property {

/// The box that an algorithm works on; every line of it along axis `along` is one system.
struct Box {
    Taken taken = Taken::whole;
    unsigned along = 0;
    std::uint32_t length = 0, systems = 0;
    glift::uint2 extent, origin, size, capacity;  ///< extent: of the structure; capacity: equal to size, but along x an
                                                  ///< upper bound of it where `taken` is `counted`

    Box(Round& round, unsigned along) : taken(round.taken()), along(along) {
        length = round.size();
        // Bounds the number of elements: long systems are few. One time in four length and number are exchanged.
        systems = round.size(std::min(limit() / std::max(length, 1u), round.chance(4) ? 3000u : 70u));
        if (round.chance(4)) std::swap(length, systems);
        size = along == 0 ? glift::uint2(length, systems) : glift::uint2(systems, length);
        capacity = size;
        // Fewer columns are added beside the box where columns are long, to bound the number of elements.
        const std::uint32_t most = std::min(600u, limit() / std::max(size.y, 1u) + 3);
        if (taken == Taken::counted) capacity.x += round.below(round.chance(2) ? most : 3);
        if (taken != Taken::whole) origin = {round.below(20), round.below(20)};
        extent = taken == Taken::whole ? size : origin + capacity + glift::uint2(round.below(20), round.below(20));
        if (extent.x == 0 || extent.y == 0) {
            // These tests make no structures without elements: an empty box is a part of one.
            if (taken == Taken::whole) taken = Taken::part;
            extent = {std::max(extent.x, 1u), std::max(extent.y, 1u)};
        }
        round.about(std::to_string(systems) + " systems of " + std::to_string(length) + " along " +
                    std::to_string(along) + " from " + std::to_string(origin.x) + ", " + std::to_string(origin.y) +
                    " of " + std::to_string(extent.x) + " x " + std::to_string(extent.y) + ", place for " +
                    std::to_string(capacity.x) + " x " + std::to_string(capacity.y));
    }

    /// The box as struct `Area` of forms.glift.
    template <class Area> Area area() const {
        return {.taken = static_cast<glift::uint>(taken), .origin = origin, .size = capacity};
    }
    /// A structure of one element, the size: where `taken` is `counted`, pipelines read it there.
    template <class Extents> Extents size_on(const glift::Device& device) const {
        Extents sizes(device, 1);
        sizes.write(std::vector<glift::uint2>{size});
        return sizes;
    }

    std::size_t count() const { return std::size_t{extent.x} * extent.y; }
    /// The row-major index in the structure of element i of a system.
    std::size_t place(std::uint32_t system, std::uint32_t i) const {
        const std::size_t x = origin.x + (along == 0 ? i : system), y = origin.y + (along == 0 ? system : i);
        return y * extent.x + x;
    }
};

}  // namespace property
