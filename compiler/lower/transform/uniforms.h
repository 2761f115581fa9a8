// Uniform values, which are the same for all invocations, become parameters of the pass.
//
// Needs: bodies of memory operations. Guarantees: no member, memory_extent, host_state, domain or value parameter is
// left in them.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// Every uniform expression becomes a parameter, which the host computes, unless it is a constant, or a few operations
/// on parameters that the pass has anyway, or of a type that cannot be a parameter (an optional, or a type that has
/// empty structs in it).
void move_uniforms(Context& cx, const std::vector<std::vector<StmtId>*>& bodies);

/// For library functions: only the state itself becomes parameters, and the shader computes uniform expressions, so
/// that the user, who fills in the parameters, has to compute nothing.
void name_state(Context& cx, const std::vector<std::vector<StmtId>*>& bodies);

}  // namespace gliftc::lower
