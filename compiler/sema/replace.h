// `member = temporary;` in a pipeline: a member of the container gets other memory.
#pragma once

#include "sema/body.h"

namespace gliftc::sema {

/// Whether the assignment is to a structure, which is checked then, and the statement emitted.
bool check_replace(Body&, const ast::Stmt&);

}  // namespace gliftc::sema
