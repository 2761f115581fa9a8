// Loop fission at derivatives, for devices whose fragments are loops over the pixels of a block: what is derived is
// computed for all of them, then each takes what its neighbours have.
//
// Needs: a fragment part whose derivatives stand in control flow that is the same for a whole triangle, or at least
// for each quad of it. Guarantees: a derivative's operand is a local that is kept for each fragment, which a barrier
// separates from the derivative; all statements that differ between fragments are in `invocations`.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> split_at_derivatives(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
