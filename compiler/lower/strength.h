// Addresses relative to each other: an integer that differs from one already computed by a uniform amount becomes that
// one plus the amount.
//
// Works on polynomials modulo 2^32 over what is not further known (address components, loaded values) and knows no
// container: the neighbour's address in a row-major array is the centre's plus a stride because their polynomials
// differ by one. Needs: shared bodies (share.h). Guarantees: the same values.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> strengthen(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
