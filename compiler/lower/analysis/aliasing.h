// Aliases: calls may pass one memory for two parameters if each invocation accesses only its own element by both
// (docs/reference/language.md, "Aliasing"). The two parameters then have "one place": they name the same
// element.
//
// The general form is valid for such calls: a store by one binding counts as a store by all bindings that
// may alias it (number.h), so that no load is moved past it. No passes are compiled for particular aliases, since there
// would be one for each partition of the set of parameters. On Vulkan devices too, such calls run the general form: its
// buffers are pointers, which may be equal. Images have descriptors in both forms; an image that is loaded after a
// store by a binding that may alias it is a storage image, not a texture, so that the invocation sees its own store
// (see agree() in loops.h). The direct form assumes that there are no aliases. An invocation of its shaders may compute
// two elements, both before the first store; if possible aliases forbid that in the general form, it computes the two
// elements one after the other.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// The value of one_place for `binding`, which is about to be added to the pass: the first binding that may alias it,
/// or its own index.
std::uint32_t first_of_place(const Context& cx, const ir::PassBinding& binding);

/// Whether the invocation's own element of the parameter `root` may be written through another parameter, which may
/// alias it.
bool may_be_written_elsewhere(const Context& cx, std::uint32_t root);

/// Whether, among bindings that may alias (`place` is their one_place), a load may come after a store in the body. Such
/// a load must not be from a sampled image: that would give the value from before the pass.
bool loads_after_store(const ir::Program& program, const ir::Pass& pass, std::uint32_t place);

}  // namespace gliftc::lower
