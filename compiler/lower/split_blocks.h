// What the number of a block decides is done once a block on the host device: the loop over its elements has the rest.
//
// Needs: the body for blocks all of whose elements are visited, with trees, whose statement `evaluate` says where it is
// right. Guarantees: Variant::block has the values that depend on the block alone, and ends with that statement.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// Absent where the condition depends on more than the block.
std::optional<ir::Variant> split_blocks(Context& cx, const ir::Variant& variant);

}  // namespace gliftc::lower
