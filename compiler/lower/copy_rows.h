// In kernels over blocks, on the host device: turns each loop that copies a constant number of consecutive elements, of
// memory that the pass only reads, to a local array, once a block, into one copy_row statement (bools and coherent
// memory excepted). C++ compilers cannot do that themselves, since they cannot know that the 32-bit indices do not
// wrap.
//
// Needs: variants for the host device whose blocks are split (split_blocks.h). Guarantees: copy_row in place of such
// loops.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> copy_rows(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
