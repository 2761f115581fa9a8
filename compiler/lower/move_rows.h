// On the host device: replaces loops that copy consecutive rows of four scalars between a local array and memory by one
// load_rows or store_rows statement, a copy that C++ compilers vectorise.
//
// Needs: expressions are trees. Guarantees: there are no loops left that copy a whole array in this way.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> move_rows(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
