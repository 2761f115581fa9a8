// Kernels are identified by a hash of their contents.
#pragma once

#include <glift/pass.h>

namespace glift::detail {

/// Kernel::digest or, where that is 0, a hash of the kernel's contents.
std::uint64_t digest_of(const Kernel& kernel);

}  // namespace glift::detail
