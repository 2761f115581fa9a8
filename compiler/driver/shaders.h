// Compiles kernels to SPIR-V, on all cores, since this takes most of a compilation's time.
#pragma once

#include "driver/compile.h"
#include "emit/cpp/emit.h"

#include <set>

namespace gliftc {

/// The shaders; those of kernels that are not in `kernels` are empty. Throws
/// std::runtime_error, with the kernel's name, if glslang rejects the generated GLSL or the validator the SPIR-V.
cpp::KernelCodes compile_shaders(const Compilation& compilation, const std::set<ir::KernelId>& kernels, bool optimize);

/// From now on this process keeps the shaders that it has compiled, and takes those whose GLSL is the same: for
/// processes that compile a program again and again. Debug information of a shader that was taken may name lines that
/// moved since.
void keep_shaders();

}  // namespace gliftc
