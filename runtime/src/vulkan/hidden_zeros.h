// Hides constant zeros from the driver's optimiser.
//
// Mesa's llvmpipe simplifies 0 * x, 0 / x, x + 0 and select(c, -1, 0) wherever the zero is a constant, also where
// signed zeros, infinities and not-a-number are to be kept (gallivm's arithmetic looks at constants by itself). There
// constants become values that are computed from one that the compiler does not know, the top bit of an invocation's
// number: zeros wherever something is computed with them, others where they are passed on, to variables and functions,
// where a zero may be made of them (1 - 1). So do integers that become floats: the counter of a loop that is unrolled.
// Values that atomic operations combine are kept integers in the same way, where they are the bits of floats.
// Integers of 32 bits that become ones of 64 are kept from comparisons with constants, which Mesa gets wrong.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace glift::detail {

/// The same module with all float zeros hidden.
std::vector<std::uint32_t> with_hidden_zeros(std::span<const std::uint32_t> spirv);

}  // namespace glift::detail
