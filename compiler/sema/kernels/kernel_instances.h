// `pub kernel name = generic<…>, generic<…>;`: instances of generic kernels of the module that C++ programs call by one
// name.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// Makes the instances that the declaration lists, and makes them public under its name.
void check_kernel_instances(Context&, ast::DeclId);

}  // namespace gliftc::sema
