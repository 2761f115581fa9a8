// Workgroup memory: shared arrays of one type whose lifetimes are apart take the same place.
#pragma once

#include "ir/pass.h"

namespace gliftc::layout {

/// Fills shared_places and shared_bytes. An array lives from the first to the last statement of the body that names it;
/// two are apart where a barrier that all invocations come by lies between.
void place_shared(const ir::Program& program, ir::Pass& pass);

}  // namespace gliftc::layout
