// Loads from bindings by physical address.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// The operand of a load or store for a physical address: for a buffer an index, of 64 bits in wide passes; for an
/// image the texel's address as signed integers.
ExprId index_of(Context& cx, std::uint32_t binding, ExprId physical);

/// A load from a physical address.
ExprId load_from(Context& cx, std::uint32_t binding, ExprId physical);

}  // namespace gliftc::lower
