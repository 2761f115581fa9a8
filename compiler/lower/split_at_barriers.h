// Loop fission at barriers, for devices whose workgroups are loops: what lies between two barriers is done for one
// invocation after the other. A statement that contains a barrier is done once for all of them, with the condition that
// the first invocation has: it is uniform, or the kernel is wrong on every device.
//
// Needs: a kernel with a group, and its prologue. Guarantees: barriers stand outside of `invocations`; a local that is
// used in more than one of them, or in one and outside, is kept for each invocation, unless it counts the rounds of a
// loop that all of them run together.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> split_at_barriers(Context& cx, const std::vector<StmtId>& body);

/// The same of a body that declares all that it uses, or has it from outside.
std::vector<StmtId> regions_between_barriers(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
