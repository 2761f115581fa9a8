// Address arithmetic in 64 bits.
//
// Addresses and extents are 32-bit numbers, and what is computed from them wraps around at 2^32. In the extent of a
// memory that would be too little memory, and in a physical address another element. Here such code is copied with
// every sum, product and left shift of uints, and what is made of them, in 64 bits. Code whose numbers can't grow stays
// as it is.
#pragma once

#include "ir/ir.h"

namespace gliftc::lower {

/// Memories' extents and the arguments of nested structures become exact: 64-bit numbers that stay at 2^64 - 1 where
/// they would pass it. Before kernels are lowered.
void widen_extents(ir::Program& program);

/// Makes the 64-bit copies of the translators that lead to a number: Translator::wide. Before kernels are lowered.
void widen_translators(ir::Program& program);

}  // namespace gliftc::lower
