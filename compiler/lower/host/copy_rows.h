// In kernels over blocks, on the host device: a loop that copies a constant number of consecutive elements from memory
// to a local array becomes one copy_row statement, if the binding of the memory is only read and not coherent, and the
// elements are not bools. C++ compilers do not make one copy of such a loop, since they cannot know that the 32-bit
// indices do not wrap.
//
// Needs: Variant::block, as split_blocks makes it: the statements that run once a block. Guarantees: copy_row in place
// of such loops.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

std::vector<StmtId> copy_rows(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
