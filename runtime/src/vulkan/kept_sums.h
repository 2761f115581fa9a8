// Keeps a driver from adding and subtracting floats while it compiles a shader.
//
// NVIDIA's driver (580, seen on an H200) computes `22642620.0 - 1.0` of constants to 22642618: a difference that lies
// between two floats is rounded towards zero, whatever rounding mode is stated. It finds such differences after it
// unrolls loops and inlines functions, so that a compiler of the language cannot fold them all before. Where both
// operands may be constants by then, a value that is -0, which the driver does not know, is added to one of them: that
// changes no number. That takes one more addition in such places, which are rare.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace glift::detail {

/// The same module, without sums and differences of floats that the driver may compute. Modules without the
/// invocation's or the workgroup's number among their inputs (draws) stay as they are.
std::vector<std::uint32_t> with_kept_sums(std::span<const std::uint32_t> spirv);

}  // namespace glift::detail
