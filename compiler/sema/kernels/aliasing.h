// Aliasing: one structure, or several that share a memory, passed for several parameters of a kernel.
#pragma once

#include "sema/bodies/body.h"

namespace gliftc::sema {

/// Reports the first two parameters that access one memory so that invocations may race, unless the kernel declares
/// them @disjoint. Only whole structures are compared: slices, and what views and translators read, are left to the
/// runtime.
void check_one_memory(Body&, const ir::Kernel&, const ir::Operands& arguments);

}  // namespace gliftc::sema
