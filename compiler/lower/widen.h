// Widens address arithmetic to 64 bits.
//
// In the language, addresses and extents are 32-bit numbers, and arithmetic on them wraps around at 2^32. A wrapped
// extent would allocate too little memory, and a wrapped physical address would be that of another element. Here such
// code is copied with every sum, product and left shift of uints, and all that depends on them, in 64 bits. Code
// without such operations stays as it is.
#pragma once

#include "ir/ir.h"

namespace gliftc::lower {

/// Makes the extents of memories and the arguments of nested structures exact: 64-bit numbers that saturate at 2^64
/// - 1. Called before kernels are lowered.
void widen_extents(ir::Program& program);

/// Makes the 64-bit copies of translators with scalar physical addresses: Translator::wide. Called before kernels are
/// lowered.
void widen_translators(ir::Program& program);

}  // namespace gliftc::lower
