// Changes a SPIR-V module so that devices may not fuse its float arithmetic, nor choose the results of minima and
// maxima of NaN.
#pragma once

#include "emit/spirv/emit.h"

#include <cstdint>
#include <vector>

namespace gliftc::spirv {

/// Replaces FMin, FMax and FClamp by NMin, NMax and NClamp, which are defined for NaN. With Contraction::off decorates
/// the results of all arithmetic instructions on floats (not those of GLSL.std.450) NoContraction.
std::vector<std::uint32_t> made_exact(const std::vector<std::uint32_t>& words, Contraction contraction);

}  // namespace gliftc::spirv
