// `-D name=value`: values for the constants of the modules named on the command line.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// Reports every `-D` whose name no root module declares as a constant.
void check_defines(Context&);

/// The value of the constant: from the command line, else `written`. An absent id after an error.
ir::ExprId defined_value(Context&, ast::DeclId, ir::ExprId written);

}  // namespace gliftc::sema
