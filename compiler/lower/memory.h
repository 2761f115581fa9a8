// How bindings are accessed by physical address.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// What the binding is indexed by: a buffer by numbers, in the wide form of 64 bits; an image by signed texel
/// addresses.
ExprId index_of(Context& cx, std::uint32_t binding, ExprId physical);

/// The load of what lies at a physical address.
ExprId load_from(Context& cx, std::uint32_t binding, ExprId physical);

}  // namespace gliftc::lower
