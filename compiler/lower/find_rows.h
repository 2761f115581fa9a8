// Prepares the host device's loop over the elements of a row for vectorisation by C++ compilers. Finds accesses whose
// index advances by one from element to element: they become row_load and row_store, accesses through a pointer to the
// row, since compilers cannot know that a 32-bit index does not wrap. Clamps of an index (of border translators) hide
// such accesses; where they change nothing, in the middle of a row, a variant without them is made. Also finds in which
// order elements may be executed.
//
// Needs: variants for the host device of a kernel without a group. Guarantees: row_load and row_store for such accesses
// that every element executes; the variant without clamps, if it has more of them; Variant::order.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// The variant with row accesses; and after it, if there is one, the variant for where clamps change nothing.
std::vector<ir::Variant> find_rows(Context& cx, const ir::Variant& variant);

}  // namespace gliftc::lower
