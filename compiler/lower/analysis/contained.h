// Proves that physical addresses lie in a structure's memory, whatever its constructor arguments are: accesses then
// need no bounds check.
//
// Translators and extents are interpreted over symbolic sums of the constructor's arguments
// (lower/analysis/symbolic.h), and the largest address is compared with the memory's extent. Sizes of memories, and
// arguments of members that the structure makes, do not wrap around, since the runtime makes no structure for which
// they would; other sums may (BoundsInterpreter::fits). Where code cannot be interpreted, or the sums cannot be
// compared, each access is checked.
#pragma once

#include "ir/ir.h"

namespace gliftc::lower {

/// Sets Structure::contained_axes of every structure.
void mark_contained(ir::Program& program);

}  // namespace gliftc::lower
