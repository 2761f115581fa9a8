// On the host device: replaces each loop that copies consecutive rows of four scalars between a local array and memory
// by one load_rows or store_rows statement, a copy that C++ compilers vectorise.
//
// Needs: expressions are trees. Guarantees: no loop is left that has the form rows.cpp gives to a copy between a whole
// array of scalars and consecutive rows, one row per iteration; arrays of bools, arrays in workgroup memory and
// coherent memory excepted.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> move_rows(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
