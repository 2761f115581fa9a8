// The free names of a closure: those that neither its parameters nor declarations inside it bind.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// The first use of each free name, in the order of the source; an ExprKind::name each. Whether a name means a value, a
/// function or a type is not looked up.
std::vector<ast::ExprId> free_names(const Context&, ast::ExprId closure);

}  // namespace gliftc::sema
