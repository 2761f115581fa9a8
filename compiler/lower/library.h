// Functions of structures for the user's own shaders, each for one address. Every structure and view has `read`. It has
// `write`, unless a view computes the elements or an image of depths (d32) has them. It has `translate`, if it has a
// translator or its memory is a structure; then it has `is_mapped`, too, unless its memory is no structure, no
// translator is partial, and no address leads outside the memory. It has `sample` if elements can be filtered without a
// sampler, or the structure's own one, and with this its own `gather`, `compare` and `contains`.
#pragma once

#include "diag/diagnostics.h"
#include "ir/pass.h"

namespace gliftc::lower {

/// Makes the functions of every structure and view that a module named on the command line makes public. Adds nodes to
/// the program. Needs: lower() has run.
std::vector<ir::Library> lower_libraries(ir::Program& program, Diagnostics& diagnostics);

}  // namespace gliftc::lower
