// Loads under a predicate: in kernels with a group, what is loaded where a condition holds and counts only there is
// loaded under a branch.
//
// A choice between what was loaded and another value waits for it before the next barrier. Under a branch, which GPUs
// make a predicate, nothing waits before the value is used, so that loads stay under way across barriers. Needs: shared
// bodies (share.h) without dead lets. Guarantees: the same values.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> predicate_loads(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
