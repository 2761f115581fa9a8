// `member = temporary;` in a pipeline: a member of the container gets other memory.
#pragma once

#include "sema/body.h"

namespace gliftc::sema {

/// Whether the assignment is to a structure, which is checked then, and the statement emitted.
bool check_replace(Body&, const ast::Stmt&);

/// At the end of a pipeline: what was given to other members is replaced together with them, so that they do not keep
/// the memory that it had.
void check_replaced_together(Body&);

/// Once all pipelines are known: no container gives to one of its members what a member of its members may get other
/// memory for: what was made over it would keep the memory that it had.
void check_given(Context&);

}  // namespace gliftc::sema
