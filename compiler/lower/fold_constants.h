// Arithmetic of float constants in functions that stay functions is computed here, as in bodies, whose expressions fold
// as they are made (make.h). glslang would compute it in doubles: -0.001 * -0.001 of floats is 1.00000011e-6, not 1e-6.
//
// Needs: checked functions. Guarantees: what a function computes of constants alone, and is a finite scalar or vector
// of floats, is a constant; the same values.
#pragma once

#include "ir/ir.h"

#include <vector>

namespace gliftc::lower {

/// The functions in which something was computed.
std::vector<ir::FunctionId> fold_constants(ir::Program& program);

}  // namespace gliftc::lower
