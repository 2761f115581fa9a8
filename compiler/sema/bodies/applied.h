// Calls of values: of a value `f` of a struct or enum, `f(x, y)` means `apply(f, x, y)`. So functions that are given to
// other functions are called like any others, closures among them.
#pragma once

#include "sema/bodies/body.h"

namespace gliftc::sema {

/// The call of 'apply' that the call means; empty if what it calls is no value of a struct or enum.
ast::ExprId applied_call(Body&, ast::ExprId call, const Operand& callee);

}  // namespace gliftc::sema
