// Loops that copy a row of memory to a row of an array that is filled once a block: one statement each, which needs to
// know of no 32-bit index that may wrap.
//
// Needs: variants for the host device whose blocks are split (split_blocks.h). Guarantees: copy_row in place of such
// loops.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> copy_rows(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
