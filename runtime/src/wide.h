// Whether buffers are so large that kernels have to count their elements in 64 bits.
#pragma once

#include <glift/pass.h>

namespace glift::detail {

/// Whether one of these buffers has 2^32 elements or more. Tests set another number by the environment variable
/// GLIFT_WIDE_ELEMENTS.
bool counts_in_64_bits(const Kernel& kernel, std::span<const Memory> memories);

}  // namespace glift::detail
