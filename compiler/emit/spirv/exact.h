// Takes from devices the liberty to fuse float arithmetic of a SPIR-V module, and to choose what minima and maxima with
// not-a-number are.
#pragma once

#include <cstdint>
#include <vector>

namespace gliftc::spirv {

/// Decorates the results of all arithmetic instructions on floats (not those of GLSL.std.450) NoContraction, so that no
/// device fuses a multiplication with an addition, and replaces FMin, FMax and FClamp by NMin, NMax and NClamp, which
/// are defined for not-a-number.
std::vector<std::uint32_t> made_exact(const std::vector<std::uint32_t>& words);

}  // namespace gliftc::spirv
