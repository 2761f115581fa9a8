// lower: from kernels that speak of structures to passes that speak of memory, in three forms each (ir/pass.h).
#pragma once

#include "diag/diagnostics.h"
#include "ir/pass.h"

namespace gliftc::lower {

/// Lowers every kernel. Adds to the program's arenas; kernels stay as they were. Also ends the life of pipelines' temporaries
/// (release statements) and marks affine translators.
ir::Lowered lower(ir::Program& program, Diagnostics& diagnostics);

}  // namespace gliftc::lower
