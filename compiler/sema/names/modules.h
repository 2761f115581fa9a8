#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// Fills Context::scopes, Context::module_of and Program::modules; reports names that occur twice among the
/// declarations of a module (other than overloads), the generic parameters of a declaration, or the fields or methods
/// of a translator.
void collect_modules(Context&);

}  // namespace gliftc::sema
