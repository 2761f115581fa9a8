// One structure given for several parameters of a pass (docs/language.md, "One memory given twice").
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// Reports what is wrong whatever the sizes are: parameters that are all of one structure and meet. Calls with boxes
/// are looked at when they run.
void check_one_memory(Context&, const ir::Kernel&, const ir::Operands& arguments);

}  // namespace gliftc::sema
