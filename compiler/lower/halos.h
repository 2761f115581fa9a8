// Halos: what `near` reads around the elements of a block, copied once a block on the host device.
#pragma once

#include "lower/context.h"

#include <map>
#include <set>
#include <vector>

namespace gliftc::lower {

/// The offsets at which near parameters are read.
using NearOffsets = std::map<std::uint32_t, std::set<std::vector<std::int64_t>>>;

/// A block's elements and those of its neighbours that are read with them, as an array of its own.
struct Halo {
    std::uint32_t root = 0;             ///< the near parameter
    std::vector<std::uint32_t> block;   ///< size of a block
    std::vector<std::uint32_t> below;   ///< elements of the copy before the block, along each axis
    std::vector<std::uint32_t> extent;  ///< of the copy
    /// What is copied of the block (steps of 0) or of a neighbour: elements from `low` on.
    struct Part {
        std::vector<int> step;
        std::vector<std::uint32_t> low, count;
    };
    std::vector<Part> parts;
    LocalId copy;  ///< the array; absent: nothing reads it yet
    ExprId at;     ///< the element's place in the array, but for the offset
    std::uint32_t elements() const {
        std::uint32_t all = 1;
        for (std::uint32_t along : extent) all *= along;
        return all;
    }
};

/// For the near parameters whose offsets end in the block or beside it, where nothing writes what is copied.
std::vector<Halo> halos_of(Context& cx, const NearOffsets& offsets);

}  // namespace gliftc::lower
