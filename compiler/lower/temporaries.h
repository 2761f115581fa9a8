// Releases the temporary structures of pipelines after their last use, so that the runtime can reuse their memory.
#pragma once

#include "ir/ir.h"

namespace gliftc::lower {

/// Adds a release statement for each temporary, after the last statement that uses it in the list of statements in
/// which it is declared; so one that a loop uses lives until the loop's end. What a pipeline returns is not released.
/// Also decides which elements that are read as values on the device (Op::device_read) need no copy.
void release_temporaries(ir::Program& program);

}  // namespace gliftc::lower
