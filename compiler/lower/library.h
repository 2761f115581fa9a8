// Functions of structures for shaders that are not Glift's: read, write and translate at one address.
#pragma once

#include "diag/diagnostics.h"
#include "ir/pass.h"

namespace gliftc::lower {

/// The functions of every public structure and view. Adds to the program's arenas. Needs: a program that was lowered.
std::vector<ir::Library> lower_libraries(ir::Program& program, Diagnostics& diagnostics);

}  // namespace gliftc::lower
