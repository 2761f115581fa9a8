// Dead code elimination: drops `let`s and assignments of locals that nothing uses, ifs, blocks and for loops that are
// empty, and what follows a return, break or continue. Expressions with effects (atomic and subgroup operations) stay
// if they are reached. Also resolves an `if` whose condition is the constant true, or the constant false without an
// else.
//
// Needs: a body of memory operations, or a function without structures. Guarantees: the same values, stored in the same
// order.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> drop_dead(Context& cx, const std::vector<StmtId>& body);

/// Drops dead code in the functions without structures, which lowered kernels call as they are. It is not left to
/// drivers' compilers: NVIDIA's crashed on a function most of which was dead. Returns the functions that have changed.
std::vector<ir::FunctionId> drop_dead(ir::Program& program);

}  // namespace gliftc::lower
