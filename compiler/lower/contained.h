// Whether translated addresses lie in a structure's memory, whatever it is made with: then no access asks.
//
// Translators and extents are followed over sums of what the structure is made with (lower/symbolic.h), and the largest
// address is compared with the memory's extent. Sizes are taken not to wrap around: a structure with such ones is not
// made. What cannot be followed or compared is guarded at each access.
#pragma once

#include "ir/ir.h"

namespace gliftc::lower {

/// Sets Structure::contained_axes of every structure.
void mark_contained(ir::Program& program);

}  // namespace gliftc::lower
