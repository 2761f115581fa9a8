// `member = temporary;` in a pipeline of a container: the member gets the memory of the temporary.
#pragma once

#include "sema/bodies/body.h"

namespace gliftc::sema {

/// Whether the assignment is one to a structure (not a slice) in a pipeline. If so, checks it, and emits the statement
/// unless there is an error.
bool check_replace(Body&, const ast::Stmt&);

/// At the end of a pipeline: checks that members which share memory are replaced together. If the constructor of a
/// member N takes a member M or a part of it, then replacing M alone would leave N with M's old memory: the block has
/// to replace N as well, by a temporary made with M's new memory. Reports the replacement of M otherwise.
void check_replaced_together(Body&);

/// Once all pipelines are known: reports members that would keep an old memory. That is a member whose constructor
/// takes a structure inside another member, if a pipeline may replace that structure or one that contains it
/// (check_replaced_together() checks the other member itself). It is also a memory that is a level or layer of an image
/// in a member, if that member, or the structure with the image, may be replaced.
void check_given(Context&);

}  // namespace gliftc::sema
