// Uniformity analysis: barriers and derivatives must be in uniform control flow (docs/reference/language.md,
// "Workgroups" and "Draws").
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// Reports barriers of a kernel with a workgroup, and of the functions that it calls, in divergent control flow: under
/// a condition or in a loop that may differ between the invocations that the barrier synchronises.
void check_barriers(Context&, const ir::Kernel&);

/// Reports derivatives (dFdx and the like) in a fragment part where control flow may differ between the fragments of a
/// quad.
void check_derivatives(Context&, const ir::Kernel&);

}  // namespace gliftc::sema
