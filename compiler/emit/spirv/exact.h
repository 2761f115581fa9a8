// Changes a SPIR-V module so that devices may not fuse its float arithmetic, nor choose the results of minima and
// maxima of NaN.
#pragma once

#include <cstdint>
#include <vector>

namespace gliftc::spirv {

/// Decorates the results of all arithmetic instructions on floats (not those of GLSL.std.450) NoContraction, so that no
/// device fuses a multiplication with an addition, and replaces FMin, FMax and FClamp by NMin, NMax and NClamp, which
/// are defined for NaN.
std::vector<std::uint32_t> made_exact(const std::vector<std::uint32_t>& words);

}  // namespace gliftc::spirv
