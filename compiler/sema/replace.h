// `member = temporary;` in a pipeline of an adaptor: the member gets the memory of the temporary.
#pragma once

#include "sema/body.h"

namespace gliftc::sema {

/// Whether the assignment is to a structure. If so, checks it and emits the statement.
bool check_replace(Body&, const ast::Stmt&);

/// At the end of a pipeline: reports a member whose memory was replaced while another member, whose constructor was
/// given the first, was not made anew over the new memory: it would keep the old one.
void check_replaced_together(Body&);

/// Once all pipelines are known: reports a member whose constructor is given a structure inside another member, and a
/// memory that is a level or layer of an image there, if some pipeline may replace that structure: the member or memory
/// would keep the old one.
void check_given(Context&);

}  // namespace gliftc::sema
