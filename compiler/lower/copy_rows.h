// In kernels over blocks, on the host device: turns each loop that copies a constant number of consecutive elements, of
// memory that the pass only reads, to a local array, into one copy_row statement (bools and coherent memory excepted).
// C++ compilers cannot do that themselves, since they cannot know that the 32-bit indices do not wrap.
//
// Needs: Variant::block, as split_blocks makes it: the statements that run once a block. Guarantees: copy_row in place
// of such loops.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> copy_rows(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
