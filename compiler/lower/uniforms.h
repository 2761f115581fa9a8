// Moves uniform work to the host: every expression that is the same for all invocations becomes a parameter, unless a few
// operations on parameters that the kernel has anyway give it.
//
// Needs: low-level bodies. Guarantees: no member, memory_extent, domain or value parameter is left in them.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

void move_uniforms(Context& cx, const std::vector<std::vector<StmtId>*>& bodies);

}  // namespace gliftc::lower
