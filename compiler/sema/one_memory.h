// One structure, or one memory of several, given for several parameters of a pass.
#pragma once

#include "sema/body.h"

namespace gliftc::sema {

/// Reports parameters of a call that are given one memory as a whole where invocations would race.
void check_one_memory(Body&, const ir::Kernel&, const ir::Operands& arguments);

}  // namespace gliftc::sema
