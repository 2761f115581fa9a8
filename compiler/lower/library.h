// Functions of structures for the user's own shaders: read, write and translate at one address, and, where not every
// address is known to be mapped, is_mapped. Views have only read. Structures whose memory is a view or an image of
// depths (d32) have all but write.
#pragma once

#include "diag/diagnostics.h"
#include "ir/pass.h"

namespace gliftc::lower {

/// Makes the functions of every structure and view that a module named on the command line makes public. Adds nodes to
/// the program. Needs: lower() has run.
std::vector<ir::Library> lower_libraries(ir::Program& program, Diagnostics& diagnostics);

}  // namespace gliftc::lower
