// Allocates workgroup memory: arrays with elements of one type and disjoint lifetimes share an allocation.
#pragma once

#include "ir/pass.h"

namespace gliftc::layout {

/// Fills shared_places and shared_bytes. An array is live from the first to the last top-level statement that names it.
/// Two lifetimes are disjoint if a top-level barrier separates them; top-level: under no condition and in no loop.
void place_shared(const ir::Program& program, ir::Pass& pass);

}  // namespace gliftc::layout
