// Finds updates that all elements of a row make to one element of memory: the host device combines them before it
// updates memory (glift/host/updates.h). Sums of floats in one order (ir::SumOrder) are combined along a row or a
// column, as they are in shaders (glift/host/sums.h).
//
// Needs: a variant for the host device of a kernel without a group, after "find_rows". Guarantees: such updates are
// row_update or column_update; Variant::order is `any` if nothing else orders the elements.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

void find_row_updates(Context& cx, ir::Variant& variant);

}  // namespace gliftc::lower
