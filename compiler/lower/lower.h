// lower: from kernels that speak of structures to passes that speak of memory, in three forms each (ir/pass.h).
#pragma once

#include "diag/diagnostics.h"
#include "ir/pass.h"
#include "lower/trace.h"

namespace gliftc::lower {

/// What kernels find out about themselves when they run.
enum class Checks : std::uint8_t {
    none,
    ranges,  ///< reads and writes by address outside a structure that says nothing about its outside: see check_range
};

struct Settings {
    Checks checks = Checks::none;
    Trace* trace = nullptr;  ///< or nothing is shown
};

/// Lowers every kernel. Adds to the program's arenas; kernels stay as they were. Also ends the life of pipelines'
/// temporaries (release statements) and marks affine translators.
ir::Lowered lower(ir::Program& program, Diagnostics& diagnostics, Settings settings = {});

/// One kernel as the body of a function with these parameters that reaches the structures' state and memory by name: no
/// dispatch, no range.
ir::Pass lower_function(ir::Program& program, Diagnostics& diagnostics, const ir::Kernel& kernel,
                        std::vector<ir::LocalId> params);

}  // namespace gliftc::lower
