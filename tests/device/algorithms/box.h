// Boxes of two-dimensional structures: systems of equations and rows that are filtered.
#pragma once

#include "property.h"

namespace property {

/// Where in two-dimensional structures the systems lie that an algorithm takes; `along` is the axis of a system.
struct Box {
    bool whole = true;
    unsigned along = 0;
    std::uint32_t length = 0, systems = 0;
    glift::uint2 extent, origin, size;

    Box(Round& round, unsigned along) : whole(round.taken() == Taken::whole), along(along) {
        if (!whole) round.only(Taken::part);
        length = round.size();
        // Long systems are few; now and then there are more systems than elements in one.
        systems = round.size(std::min(limit() / std::max(length, 1u), round.chance(4) ? 3000u : 70u));
        if (round.chance(4)) std::swap(length, systems);
        size = along == 0 ? glift::uint2(length, systems) : glift::uint2(systems, length);
        if (!whole) origin = {round.below(20), round.below(20)};
        extent = whole ? size : origin + size + glift::uint2(round.below(20), round.below(20));
        if (extent.x == 0 || extent.y == 0) {
            // Structures have an element at least.
            whole = false;
            extent = {std::max(extent.x, 1u), std::max(extent.y, 1u)};
        }
        round.about(std::to_string(systems) + " systems of " + std::to_string(length) + " along " +
                    std::to_string(along) + " from " + std::to_string(origin.x) + ", " + std::to_string(origin.y) +
                    " of " + std::to_string(extent.x) + " x " + std::to_string(extent.y));
    }

    std::size_t count() const { return std::size_t{extent.x} * extent.y; }
    /// Element i of a system in row-major memory.
    std::size_t place(std::uint32_t system, std::uint32_t i) const {
        const std::size_t x = origin.x + (along == 0 ? i : system), y = origin.y + (along == 0 ? system : i);
        return y * extent.x + x;
    }
};

}  // namespace property
