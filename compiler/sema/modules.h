#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// Fills Context::scopes, Context::module_of and Program::modules; reports what has the name of another declaration of
/// the module, generic parameter of one declaration, or field or method of one translator.
void collect_modules(Context&);

}  // namespace gliftc::sema
