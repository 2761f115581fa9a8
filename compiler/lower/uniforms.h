// Uniform work, the same for all invocations, leaves the shader or rests on its parameters.
//
// Needs: low-level bodies. Guarantees: no member, memory_extent, domain or value parameter is left in them.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// Moves it to the host: every uniform expression becomes a parameter, unless a few operations on parameters that the
/// kernel has anyway give it.
void move_uniforms(Context& cx, const std::vector<std::vector<StmtId>*>& bodies);

/// Leaves it where it is: only the state itself becomes parameters, so that whoever fills them in computes nothing.
void name_state(Context& cx, const std::vector<std::vector<StmtId>*>& bodies);

}  // namespace gliftc::lower
