// Halos, on the host device: in kernels over blocks, the elements that are read through a `near` parameter from a block
// and the adjacent blocks are copied to a local array once per block.
#pragma once

#include "lower/context.h"

#include <map>
#include <set>
#include <vector>

namespace gliftc::lower {

/// For each near parameter (its index) offsets at which it is read: those that Expander::near_offsets notes.
using NearOffsets = std::map<std::uint32_t, std::set<std::vector<std::int64_t>>>;

/// The local array for one near parameter: a block's elements, and around them those of adjacent blocks that are read.
struct Halo {
    std::uint32_t root = 0;             ///< the near parameter
    std::vector<std::uint32_t> block;   ///< size of a block
    std::vector<std::uint32_t> below;   ///< how many elements the array has before the block's first, along each axis
    std::vector<std::uint32_t> extent;  ///< size of the array along each axis
    /// A box of elements that is copied from the block at `step` (along each axis -1, 0 or 1; all 0: the block itself):
    /// along each axis `count` elements, from position `low` in that block on.
    struct Part {
        std::vector<int> step;
        std::vector<std::uint32_t> low, count;
    };
    std::vector<Part> parts;
    LocalId copy;  ///< the array; absent: nothing reads it yet
    ExprId at;     ///< index that the current element would have in the array if `below` were all zero
    std::uint32_t elements() const {
        std::uint32_t all = 1;
        for (std::uint32_t along : extent) all *= along;
        return all;
    }
};

/// The halos, in the order of the parameters. A near parameter has one if `offsets` has an offset other than zero for
/// it and none that reaches beyond the adjacent blocks, if its elements are numbers or vectors of numbers and are not
/// computed by a view, if the pass only reads its memory, which is not coherent, and if the copies, with those for
/// earlier parameters, have 32,768 scalars at most. None if the size of a block is not constant, or if a block has
/// fewer than 8 or more than 32,768 elements.
std::vector<Halo> halos_of(Context& cx, const NearOffsets& offsets);

}  // namespace gliftc::lower
