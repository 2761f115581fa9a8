// `member = temporary;` in a pipeline of an adaptor: the member gets the memory of the temporary.
#pragma once

#include "sema/body.h"

namespace gliftc::sema {

/// Whether the assignment is to a structure. If so, checks it and emits the statement.
bool check_replace(Body&, const ast::Stmt&);

/// At the end of a pipeline: reports a member whose memory was replaced while another member, whose constructor is
/// given the first or a part of it, was not made anew over the new memory in the same block: it would keep the old one.
void check_replaced_together(Body&);

/// Once all pipelines are known: reports a member whose constructor is given a structure inside another member, if some
/// pipeline may replace that structure or one around it, but for the outermost. Likewise a memory that is a level or
/// layer of an image in a member, if that member, or one in it that has the image, may be replaced. They would keep
/// the old memory.
void check_given(Context&);

}  // namespace gliftc::sema
