// Loop interchange, for the host device: a kernel whose elements all run one loop over the same range runs it for a
// run of consecutive elements of a row, a round of each element after the other. C++ compilers vectorise the loop over
// the elements, and what a round loads for all of them is loaded once.
//
// Needs: the body, after the other passes for the host device, of a kernel without a group, blocks, updates or coherent
// parameters. Guarantees: the body is `cut`s, `keep`s and `invocations` (the elements of a run), with the loop around
// the `invocations` of a round; or there is none, because the kernel has no such loop or a round has stores, jumps or
// loops of its own. What an element computes is unchanged, and so is its order.
//
//     for k { let q = all[k]; sum += q * p; }   ->   invocations { … }  for k { let q = all[k]; invocations { sum += q
//     * p; } }
#pragma once

#include "lower/context.h"

#include <optional>

namespace gliftc::lower {

std::optional<std::vector<StmtId>> in_lockstep(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
