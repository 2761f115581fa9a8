// Allocates workgroup memory: shared arrays of one type with disjoint lifetimes share an allocation.
#pragma once

#include "ir/pass.h"

namespace gliftc::layout {

/// Fills shared_places and shared_bytes. An array is live from the first to the last top-level statement that names it;
/// two lifetimes are disjoint if a barrier in uniform control flow separates them.
void place_shared(const ir::Program& program, ir::Pass& pass);

}  // namespace gliftc::layout
