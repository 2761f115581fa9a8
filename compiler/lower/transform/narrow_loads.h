// Where a local holds a vector that is loaded from a buffer, and only one component of the vector is used, only that
// component is loaded. The vector may be an element or a field of one.
//
// This is not left to drivers' compilers: from some shaders that load a vec<4, int64> of which only 32 bits are used,
// and that also divide, NVIDIA's (driver 580, seen on an H100) makes code that never ends.
//
// Needs: expressions are trees. Guarantees: all values stay the same.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> narrow_loads(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
