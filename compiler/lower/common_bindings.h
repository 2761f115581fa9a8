// The forms of a kernel share one list of bindings (glift::Kernel::bindings): a memory has the same number in each of
// them. Lowering may find that one form does not access a memory that another form accesses. Or the first accesses to
// the memories may come in another order in one form, and with them its bindings. Then all forms are lowered again,
// beginning with the bindings of all of them.
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
