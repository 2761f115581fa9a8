// Releases the temporary structures of pipelines (host functions that call kernels) after their last use, so that the
// runtime can reuse their memory.
#pragma once

#include "ir/ir.h"

namespace gliftc::lower {

/// Adds release statements: a temporary is released in the list of statements in which it is declared, after the last
/// statement there that uses it. So a temporary that is declared before a loop and used in it lives until the loop's
/// end. What a pipeline returns is not released. Locals of the same list that refer to the temporary's memory are
/// released with it. Also looks at each `let` and `return` whose value is an Op::device_read, an element's value that
/// stays on the device: sets its slot to 1, so that nothing is copied, where it is certain that nothing overwrites the
/// element before the last use of the value.
void release_temporaries(ir::Program& program);

}  // namespace gliftc::lower
