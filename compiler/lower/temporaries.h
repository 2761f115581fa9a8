// Ends the life of pipelines' temporaries after their last use, so that the runtime can give their memory to later
// ones.
#pragma once

#include "ir/ir.h"

namespace gliftc::lower {

/// Adds a release statement after the last statement that uses each temporary declared in the same list of statements;
/// one that is used in a loop lives until the loop's end. What a pipeline returns is not released.
void release_temporaries(ir::Program& program);

}  // namespace gliftc::lower
