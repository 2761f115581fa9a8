// SPIR-V of kernels, compiled on all cores: the longest part of a compilation by far.
#pragma once

#include "driver/compile.h"

#include <set>

namespace gliftc {

/// The words of each form of a kernel; empty where the form does not exist or was not asked for.
struct ShaderSet {
    std::vector<std::uint32_t> direct, general, wide;
};

/// Indexed as Program::kernels; filled for `kernels`. Throws std::runtime_error, with the .glift line, where glslang
/// refuses what we wrote.
std::vector<ShaderSet> compile_shaders(const Compilation& compilation, const std::set<std::uint32_t>& kernels,
                                       bool optimize);

}  // namespace gliftc
