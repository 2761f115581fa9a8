// Loop fission at derivatives, for the host device, on which the fragment part of a draw is a loop over the pixels of a
// block: the operand of a derivative is computed for all of them, then each takes the difference of its neighbours'
// values.
//
// Needs: a fragment part whose derivatives are in control flow that is uniform for a triangle: it is executed once for
// the block, with the conditions of its first fragment. Guarantees: a derivative's operand is a local with a value for
// each fragment, and a barrier separates it from the derivative; statements that are executed for each fragment are in
// `invocations`.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> split_at_derivatives(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
