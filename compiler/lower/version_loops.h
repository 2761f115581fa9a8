// Loop versioning by hoisted range checks: guards that hold in all rounds of an invocation's loops where they hold for
// all that the loops reach. One test before the loops stands for them, and C++ compilers get loops without branches,
// which they can turn into vectors.
//
// Needs: uniform values are parameters. Guarantees: `if tests { without the guards } else { as it was }`, or the body
// as it was where no guard depends on a loop in a way that is known. The tests name the invocation's address,
// parameters and constants alone.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> version_loops(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
