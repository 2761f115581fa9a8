// Hides constant zeros from the driver's optimiser.
//
// Mesa's llvmpipe simplifies 0 * x, 0 / x, x + 0 and select(c, -1, 0) wherever the zero is a constant, even if signed
// zeros, infinities and not-a-numbers are to be kept (gallivm's arithmetic looks at constants by itself). So constants
// become values that are computed from a zero that the compiler does not know, the top bit of an invocation's or a
// workgroup's number: the hidden zero. A constant zero is replaced wherever something is computed with it; every float
// constant where it is passed on, for example to variables and functions, where a zero may be made of it (1 - 1). The
// hidden zero is also or-ed into three kinds of integers: those that become floats, since they may be known when a loop
// is unrolled (its counter); the values of atomic operations, which otherwise count as floats if they are the bits of
// floats; integers converted to 32 or 64 bits from another width, since Mesa gets comparisons of those that become
// 64-bit ones with constants wrong.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace glift::detail {

/// The module with its float zeros hidden. One that has neither an invocation's nor a workgroup's number among its
/// inputs stays as it is.
std::vector<std::uint32_t> with_hidden_zeros(std::span<const std::uint32_t> spirv);

}  // namespace glift::detail
