// `member = temporary;` in a pipeline of a container: the member gets the memory of the temporary.
#pragma once

#include "sema/bodies/body.h"

namespace gliftc::sema {

/// Whether the assignment is one to a structure (not a slice) in a pipeline. If so, checks it, and emits the statement
/// unless there is an error.
bool check_replace(Body&, const ast::Stmt&);

/// At the end of a pipeline: reports the replacement of a member M if the constructor of another member N is given M or
/// a part of it, unless N is replaced in the same block by a temporary whose constructor was given M's new memory.
/// Otherwise N would keep M's old memory.
void check_replaced_together(Body&);

/// Once all pipelines are known: reports a member whose constructor is given a structure that lies inside another
/// member, if some pipeline may replace that structure or one that contains it. The other member itself does not count:
/// check_replaced_together() checks it. Also reports a memory that is a level or layer of an image in a member, if that
/// member, or the structure in it that has the image, may be replaced. Both would keep the old memory.
void check_given(Context&);

}  // namespace gliftc::sema
