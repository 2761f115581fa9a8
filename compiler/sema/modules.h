#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// Fills Context::scopes, Context::module_of and Program::modules; reports names declared twice.
void collect_modules(Context&);

}  // namespace gliftc::sema
