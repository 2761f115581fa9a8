// The forms of a kernel share one list of bindings (glift::Kernel::bindings), by whose numbers each reads the memories
// of a call. A form may be shown not to access a memory that another one accesses, or access it at another place of its
// code: then all forms are lowered again, beginning with the bindings of all.
#pragma once

#include "lower/context.h"

#include <span>
#include <vector>

namespace gliftc::lower {

/// Whether all forms have the same bindings in the same order.
bool have_common_bindings(std::span<ir::Pass* const> forms);

/// The bindings of the first form, and what the others access beyond them.
std::vector<ir::PassBinding> union_of_bindings(std::span<ir::Pass* const> forms);

/// Adds bindings of other forms to a pass that has none yet.
void add_bindings(Context& cx, const std::vector<ir::PassBinding>& bindings);

}  // namespace gliftc::lower
