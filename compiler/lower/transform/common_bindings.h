// The forms of a kernel (ir::Form) share one list of bindings (glift::Kernel::bindings): a memory has the same number
// in each of them. Lowering may find that one form does not access a memory that another form accesses. Or one form may
// access the memories in another order, and bindings are numbered by the first access. Then all forms are lowered
// again, beginning with the union of their bindings.
#pragma once

#include "lower/context.h"

#include <span>
#include <vector>

namespace gliftc::lower {

/// Whether all forms have bindings of the same memories, with the same access, in the same order.
bool have_common_bindings(std::span<ir::Pass* const> forms);

/// The bindings of the first form, then those that only others have. Where forms access a memory differently, its
/// binding is read_write.
std::vector<ir::PassBinding> union_of_bindings(std::span<ir::Pass* const> forms);

/// Adds bindings of other forms to a pass that has none yet.
void add_bindings(Context& cx, const std::vector<ir::PassBinding>& bindings);

}  // namespace gliftc::lower
