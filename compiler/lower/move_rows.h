// Loops that move rows of numbers between an array of the invocation's own and memory, one row behind the other, become
// one copy, which C++ compilers know how to make of vectors.
//
// Needs: trees. Guarantees: what is left in loops moves something else, or only a part of an array.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> move_rows(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
