// Constant folding in functions without structures, which lowered kernels call as they are. (Other bodies fold as their
// expressions are made, see build/builder.h.) It cannot be left to the compiler of GLSL, since glslang 12 folds some
// constants wrongly: it computes floats in doubles (1e-6 for -0.001 * -0.001, which in floats is 1.00000011e-6), and
// gives 0 for abs(-33l) and false for false == (vec4(0) == vec4(2)).
//
// Needs: functions that sema accepts. Guarantees: an operator, conversion, select or intrinsic of constants alone that
// evaluate() can compute, whose value is a scalar or vector of finite numbers or of bools, is a constant, unless a
// binary operation that gives uints is part of it; a select by one bool that is known in this way is the operand that
// it selects; values stay the same.
#pragma once

#include "ir/ir.h"

#include <vector>

namespace gliftc::lower {

/// Returns the functions that have changed.
std::vector<ir::FunctionId> fold_constants(ir::Program& program);

}  // namespace gliftc::lower
