// Loads of a vector of which one component is used become loads of that component.
//
// This is not left to drivers' compilers: NVIDIA's (580, seen on an H100) makes a shader that does not end of some
// loads of a vec<4, int64> of which 32 bits are used, beside a division.
//
// Needs: trees. Guarantees: the same values.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> narrow_loads(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
