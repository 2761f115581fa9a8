// Loop fission at workgroup barriers, for the host device, on which a workgroup is a loop: the statements between two
// barriers are executed for one invocation after the other. A statement that contains a barrier, or that breaks out of
// or continues a loop with one, is executed once for all invocations, with the first one's value of its condition,
// which must be uniform on every device.
//
// Needs: the body of a kernel with a group; the prologue of the pass (Pass::prologue) is put before it. Guarantees: no
// workgroup barrier is inside an `invocations` statement; a local that is used in several such statements, or in one
// and outside, is declared by a `keep` statement, as an array with a value for each invocation, unless it is workgroup
// memory or the variable of a loop that all invocations execute together.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> split_at_barriers(Context& cx, const std::vector<StmtId>& body);

/// The same without the prologue, for the fragment part of a draw (split_at_derivatives.h), which has none.
std::vector<StmtId> regions_between_barriers(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
