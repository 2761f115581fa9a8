// Calls of values: of a value `f` of a struct or enum, `f(x, y)` means `apply(f, x, y)`. So functions that are given to
// other functions are called like any others, closures among them.
#pragma once

#include "sema/bodies/body.h"

namespace gliftc::sema {

/// The struct or enum whose value the operand is; empty if it is none.
ir::TypeId applied_type(Body&, const Operand& callee);

/// Whether the expression is a name, or a field of one: such a callee is checked twice, and so must have no effect.
bool is_path(const Context&, ast::ExprId);

/// The call of 'apply' that the call means, whose callee has an applied_type().
ast::ExprId applied_call(Context&, ast::ExprId call);

}  // namespace gliftc::sema
