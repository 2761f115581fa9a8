// lower: from kernels that speak of structures to passes that speak of memory, in three forms each (ir/pass.h).
#pragma once

#include "diag/diagnostics.h"
#include "ir/pass.h"

namespace gliftc::lower {

/// Lowers every kernel. Adds to the program's arenas; kernels stay as they were. Also ends the life of pipelines' temporaries
/// (release statements) and marks affine translators.
ir::Lowered lower(ir::Program& program, Diagnostics& diagnostics);

/// One kernel as the body of a function that reaches the structures' state and memory by name: no dispatch, no range.
ir::Pass lower_function(ir::Program& program, Diagnostics& diagnostics, const ir::Kernel& kernel);

}  // namespace gliftc::lower
