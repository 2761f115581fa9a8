// Hides constant zeros from the driver's optimiser.
//
// Mesa's llvmpipe simplifies 0 * x, 0 / x, x + 0 and select(c, -1, 0) wherever the zero is a constant, even if signed
// zeros, infinities and not-a-numbers are to be kept (gallivm's arithmetic looks at constants by itself). So constants
// become values that are computed from a zero that the compiler does not know, the top bit of an invocation's or a
// workgroup's number: the hidden zero. A constant zero is replaced where it is an operand of arithmetic; every float
// constant where it or a part of it is passed on, for example to variables and functions, where a zero may be made of
// it (1 - 1, fract(2)). Mesa finds results of `step` from the ranges of its operands, so the hidden zero is added to
// these results.
//
// The hidden zero is also or-ed into three kinds of integers:
// - those that become floats, since unrolling a loop may make constants of them (its counter);
// - the value operands of atomic exchanges, sums, minima, maxima and bit operations, since lavapipe, through physical
//   addresses, treats an integer that was bitcast from a float as a float: it compares it as one, or crashes;
// - those converted from another width to 64 bits, since Mesa gets comparisons of 64-bit integers with constants wrong
//   where it sees that they were converted; conversions to 32 bits are treated alike.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace glift::detail {

/// The module with its float zeros hidden. One that has neither an invocation's nor a workgroup's number among its
/// inputs stays as it is.
std::vector<std::uint32_t> with_hidden_zeros(std::span<const std::uint32_t> spirv);

}  // namespace glift::detail
