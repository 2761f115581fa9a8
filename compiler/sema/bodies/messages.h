// `print(…)` and `assert(condition, …)`: statements of kernels that do not draw, and of functions that such kernels
// call.
//
// Both become StmtOp::print, an assertion under a condition. Where messages are compiled out (Settings::messages) they
// are checked, and make no code: so their operands must not have effects.
#pragma once

#include "sema/bodies/body.h"

namespace gliftc::sema {

/// Whether the expression is a call of the built-in `print` or `assert`, which no declaration hides.
bool is_message(Body&, const ast::Expr&);

/// Checks such a statement and emits its code. False if the statement is another one.
bool check_message(Body&, const ast::Stmt&);

/// Notes that the body prints if the called function does; reports a call where nothing may print, and gives false.
bool add_messages(Body&, ir::FunctionId, Span call);

}  // namespace gliftc::sema
