#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// Fills Context::scopes and module_of; reports names declared twice.
void collect_modules(Context&);

}  // namespace gliftc::sema
