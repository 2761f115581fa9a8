// One memory given to a pass under two names (docs/language.md, "One memory given twice"): each invocation has one
// place, which it reads and writes by both.
//
// The general form is right for such calls, and no other one is compiled for them: a store by one name counts as a
// store by the other (number.h), so no load moves over it. A variant with one binding for each way in which names may
// meet would be as many passes as a set has partitions. Vulkan devices run the wide form, whose buffers are pointers
// that may be equal. Images have descriptors in every form; where one is loaded after a store by another name, it is a
// storage image by both, not a texture, so that the invocation sees its own store. The direct form knows nothing of all
// this: where it takes two elements an invocation and the general form cannot, since loads keep their side of stores,
// that takes them in turn.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// The first binding that a call may pass as the same place as this one, which is the last of the pass; or itself.
std::uint32_t first_of_place(const Context& cx, const ir::PassBinding& binding);

/// Whether another parameter may write the element that an invocation reads by this one.
bool may_be_written_elsewhere(const Context& cx, std::uint32_t root);

/// Whether something is loaded by one name of a place that may have been stored to by another: from a texture unit it
/// would be what was there before the pass.
bool loads_after_store(const ir::Program& program, const ir::Pass& pass, std::uint32_t place);

}  // namespace gliftc::lower
