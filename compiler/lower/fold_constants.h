// What functions that stay functions compute of constants is computed here, as in bodies, whose expressions fold as
// they are made (make.h). glslang 12 gets some of it wrong: it computes floats in doubles (-0.001 * -0.001
// is 1.00000011e-6, not 1e-6), abs(-33l) is 0 to it, and false == (vec4(0) == vec4(2)) is false.
//
// Needs: checked functions. Guarantees: what a function computes of constants alone, and is a scalar or vector of
// finite numbers or of bools, is a constant; choices whose condition is a constant are what they choose; the same
// values.
#pragma once

#include "ir/ir.h"

#include <vector>

namespace gliftc::lower {

/// The functions in which something was computed.
std::vector<ir::FunctionId> fold_constants(ir::Program& program);

}  // namespace gliftc::lower
