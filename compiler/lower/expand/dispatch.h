// The shape of the dispatch: the workgroup size, the invocation's address, and the condition that this address is in
// the visited range.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// Sets what the pass says of its dispatch: rank, group, items, whether it visits blocks, whether it can be split; and
/// its workgroup memory. Makes the locals `address` and `in_range`. For draws, sets only rank, group and items, and
/// makes no locals. Called before the body is made.
void choose_dispatch(Context& cx);

/// The condition that in_range stands for: address < size along every axis. Needs cx.size to be set.
ExprId in_range_condition(Context& cx);
/// The same of any address.
ExprId in_range_condition(Context& cx, ExprId address);

/// Of workgroups that take several rows: the address of the first element of the row of this number, along y from the
/// invocation's own address on.
ExprId first_of_row(Context& cx, ExprId row);

/// Statements that declare `address` and `in_range` from the shader's built-in inputs. Needs cx.size to be set.
std::vector<StmtId> dispatch_prologue(Context& cx);

}  // namespace gliftc::lower
