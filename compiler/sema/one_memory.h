// One structure given for several parameters of a pass (docs/language.md, "One memory given twice").
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// Reports races that do not depend on sizes: parameters that are given the same whole structure. Calls with boxes are
/// checked at run time.
void check_one_memory(Context&, const ir::Kernel&, const ir::Operands& arguments);

}  // namespace gliftc::sema
