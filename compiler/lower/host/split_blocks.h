// Loop-invariant code motion in kernels over blocks (of a structure's elements), on the host device: values that depend
// on the block alone move out of the loop over its elements.
//
// Needs: the body for blocks all of whose elements are visited, with expressions that are trees; its first `evaluate`
// statement of a bool has the condition that all elements of the block are visited. Guarantees: Variant::block has
// those statements that depend on the block alone and are a `let` of an immutable local or fill an array (Filling in
// split_blocks.cpp), and the condition.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// Absent if there is no condition, or it depends on more than the block.
std::optional<ir::Variant> split_blocks(Context& cx, const ir::Variant& variant);

}  // namespace gliftc::lower
