// Keeps a driver from adding and subtracting floats while it compiles a shader.
//
// NVIDIA's driver (580, seen on an H200) computes `22642620.0 - 1.0` of constants to 22642618: a difference that lies
// between two floats is rounded towards zero, whatever rounding mode is stated. It finds such differences after it
// unrolls loops and inlines functions, so gliftc cannot fold all of them itself. Where both operands may be constants
// by then, a -0 that the driver cannot know to be -0 is added to one of them, which changes no number. The cost is one
// more addition in such places, which are rare.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace glift::detail {

/// The module, changed so that the driver computes no sums and differences of floats itself. Modules without the
/// invocation's or the workgroup's number among their inputs (draws) stay as they are, and so do modules without 32-bit
/// floats.
std::vector<std::uint32_t> with_kept_sums(std::span<const std::uint32_t> spirv);

}  // namespace glift::detail
