// Releases the temporary structures of pipelines after their last use, so that the runtime can reuse their memory.
#pragma once

#include "ir/ir.h"

namespace gliftc::lower {

/// Adds a release statement for each temporary to the list of statements in which it is declared, after the last
/// statement there that uses it. So a temporary that is declared before a loop and used in it lives until the loop's
/// end. What a pipeline returns is not released. Also marks each Op::device_read that may refer to the element in
/// place, since nothing overwrites the element while its value is used; all others copy it.
void release_temporaries(ir::Program& program);

}  // namespace gliftc::lower
