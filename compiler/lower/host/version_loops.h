// Loop versioning by hoisted bounds checks, on the host device. One test before an invocation's loops, for the range of
// all addresses that the loops access, implies their guards; where it holds, a version without these guards runs, whose
// loops C++ compilers can vectorise if nothing else in them branches.
//
// Needs: uniform values are parameters. Guarantees: the body is `if tests { body without the guards } else { body }`,
// or unchanged if no test is found that implies a guard in all iterations of a loop. The tests use only the
// invocation's address, parameters and constants.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> version_loops(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
