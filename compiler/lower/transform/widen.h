// Widens address arithmetic to 64 bits.
//
// In the language, addresses and extents are 32-bit numbers, and arithmetic on them wraps around at 2^32. A wrapped
// extent would allocate too little memory, and a wrapped physical address would be that of another element. Here such
// code is copied with every sum, product and left shift of uints in 64 bits. What is computed from their results stays
// in 64 bits through operators, selects, vectors, optionals, min, max, clamp, comparisons, and the locals and functions
// of the language. It is narrowed to 32 bits where it is the bound of a loop, an index of an array, the address of an
// element that is read from a structure, a shift amount, an argument of an extern function or of another intrinsic (but
// not of findMSB in extents), or a part of a struct or array: in translators to its low 32 bits, in extents by a call
// that throws if the number does not fit. Code without such operations stays as it is.
#pragma once

#include "ir/ir.h"

namespace gliftc::lower {

/// Makes the extents of memories and the arguments of nested structures exact: 64-bit numbers, which saturate at
/// 2^64 - 1. Expressions without a sum, product, left shift or scalar memory extent keep 32 bits, except for extents of
/// buffers. Called before kernels are lowered.
void widen_extents(ir::Program& program);

/// Makes the 64-bit copies of translators with scalar physical addresses, for each stage of each structure
/// (Stage::wide). Called before kernels are lowered.
void widen_translators(ir::Program& program);

}  // namespace gliftc::lower
