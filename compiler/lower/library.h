// Functions of structures for the user's own shaders: read, write and translate at one address.
#pragma once

#include "diag/diagnostics.h"
#include "ir/pass.h"

namespace gliftc::lower {

/// Makes the functions of every public structure and view. Adds nodes to the program. Needs: lower() has run.
std::vector<ir::Library> lower_libraries(ir::Program& program, Diagnostics& diagnostics);

}  // namespace gliftc::lower
