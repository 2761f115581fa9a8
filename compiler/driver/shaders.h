// Compiles kernels to SPIR-V, on all cores, since this takes most of a compilation's time.
#pragma once

#include "driver/compile.h"

#include <set>

namespace gliftc {

/// The SPIR-V words of each form of a kernel; empty if the form does not exist or is not wanted. Draws have vertex
/// shaders in the first three and fragment shaders in the others.
struct ShaderSet {
    std::vector<std::uint32_t> direct, general, wide;
    std::vector<std::uint32_t> direct_fragment, general_fragment, wide_fragment;
};

/// The shaders by index in Program::kernels; those of kernels that are not in `kernels` are empty. Throws
/// std::runtime_error, with the kernel's name, if glslang rejects the generated GLSL or the validator the SPIR-V.
std::vector<ShaderSet> compile_shaders(const Compilation& compilation, const std::set<std::uint32_t>& kernels,
                                       bool optimize);

}  // namespace gliftc
