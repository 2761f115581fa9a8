// Kernels are identified by a hash of their contents.
#pragma once

#include <glift/pass.h>

namespace glift::detail {

/// Kernel::digest or, where that is 0, a hash of those of the kernel's contents that its pipelines and reports depend
/// on.
std::uint64_t digest_of(const Kernel& kernel);

}  // namespace glift::detail
