// How the host device goes through the elements of a row: which accesses move along memory with them, one by one, and
// are made through a pointer to the row, so that C++ compilers can vectorise the loop (they cannot know by themselves
// that a 32-bit index does not wrap); where clamps change nothing; whether elements depend on each other.
//
// Needs: variants for the host device of a kernel without a group. Guarantees: row_load and row_store where every
// element of the row comes by; a variant without clamps for the middle of a row, where they hide such an access; the
// order in which elements may be done.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// The variant as it is printed; behind it, if there is one, that for where its clamps change nothing.
std::vector<ir::Variant> find_rows(Context& cx, const ir::Variant& variant);

}  // namespace gliftc::lower
