// The limit on the nesting of branches in shaders.
#pragma once

#include "diag/diagnostics.h"
#include "ir/pass.h"

namespace gliftc::layout {

/// How deep branches and loops may be nested in a shader, callers of functions included. Lavapipe (Mesa 22.3) ignores
/// the conditions of branches below the 80th level. The limit leaves room for branches that printers and drivers add.
inline constexpr unsigned nesting_limit = 64;

/// Reports each kernel whose shaders exceed nesting_limit.
void check_nesting(const ir::Program&, const ir::Lowered&, Diagnostics&);

}  // namespace gliftc::layout
