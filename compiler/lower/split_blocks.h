// Loop-invariant code motion in kernels over blocks (of a structure's elements), on the host device: statements that
// depend on the block alone move out of the loop over its elements.
//
// Needs: the body for blocks all of whose elements are visited, with expressions that are trees; its `evaluate`
// statement has the condition that the block is such a one. Guarantees: Variant::block has these statements and the
// condition.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// Absent if there is no condition, or it depends on more than the block.
std::optional<ir::Variant> split_blocks(Context& cx, const ir::Variant& variant);

}  // namespace gliftc::lower
