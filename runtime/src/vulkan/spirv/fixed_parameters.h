// Replaces, by constants, the parameters whose values are known when a pipeline is made. This is like specialisation
// constants, but the shader need not declare any.
#pragma once

#include <glift/pass.h>

#include <cstdint>
#include <span>
#include <vector>

namespace glift::detail {

/// The module with loads of these words of the parameter block (push constants, else the buffer at binding 0) replaced
/// by constants. A load that also covers a word that is not fixed stays, and so does one of another type than a 32-bit
/// scalar or a vector of these, and one of a part of an array, a matrix or a struct.
std::vector<std::uint32_t> with_fixed_parameters(std::span<const std::uint32_t> spirv,
                                                 std::span<const FixedWord> fixed);

}  // namespace glift::detail
