// Strength reduction of addresses: an integer that differs from one that is already computed by a uniform amount
// becomes that one plus the amount.
//
// Works on polynomials modulo 2^32 (polynomial.h), not on particular containers: a neighbour's address in a row-major
// array is that of the current element plus a stride, because their polynomials differ by the stride. Needs: bodies
// after "share". Guarantees: the same values.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> strengthen(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
