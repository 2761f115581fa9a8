// Strength reduction of addresses: a uint that differs by a uniform amount from an earlier local is computed as that
// local plus or minus the amount. Parts of the amount may depend on conditions: c ? step : 0.
//
// Works on polynomials modulo 2^32 (polynomial.h), not on particular containers: a neighbour's address in a row-major
// array is that of the current element plus a stride, because their polynomials differ by the stride. Needs: bodies
// after "share". Guarantees: all values stay the same.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> strengthen(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
