// The shape of the dispatch: workgroup size, the invocation's address, whether it is in range.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// Before the body is made: rank, group, and the locals `address` and `in_range`.
void choose_dispatch(Context& cx);

/// The condition that in_range stands for.
ExprId in_range_condition(Context& cx);

/// Declares `address` and `in_range` from what the shader is given; cx.size is the iteration's size.
std::vector<StmtId> dispatch_prologue(Context& cx);

}  // namespace gliftc::lower
