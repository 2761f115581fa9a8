// Prepares the host device's loop over the elements of a row (elements that are consecutive along x) for vectorisation
// by C++ compilers. Finds accesses whose index advances by one from element to element: they become row_load, row_store
// and row_item, accesses through a pointer to the row, since compilers cannot know that a 32-bit index does not wrap.
// Clamps of an index, by which translators map addresses beyond a border back inside, or selects that do the same, hide
// such accesses; a variant without these "clamps" is made for the middle of a row, where they change nothing. Also
// finds in which order the elements of a row may be executed.
//
// Needs: variants for the host device of a kernel without a group. Guarantees: the operations above for such accesses
// that every element executes, outside of loops and of ifs whose condition differs along a row; the variant without
// clamps, if there are clamps and it has such accesses; Variant::order.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// The variant, with row accesses where there are any; and after it, if there is one, the variant for elements for
/// which clamps change nothing.
std::vector<ir::Variant> find_rows(Context& cx, const ir::Variant& variant);

}  // namespace gliftc::lower
