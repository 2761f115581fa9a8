// Barriers are reached by all invocations of a workgroup together (docs/language.md, "Workgroups"). What a condition is
// made of tells whether it may differ between them.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// Reports the barriers of a kernel with a workgroup, and of the functions that it calls, that stand under a condition
/// or in a loop that may differ between the invocations that it synchronises.
void check_barriers(Context&, const ir::Kernel&);

}  // namespace gliftc::sema
