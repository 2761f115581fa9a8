// Makes float arithmetic of a SPIR-V module come out the same on every device.
#pragma once

#include <cstdint>
#include <vector>

namespace gliftc::spirv {

/// Decorates the result of every float operation NoContraction, so that no device fuses a multiplication with an
/// addition, and makes FMin, FMax and FClamp their forms that are defined for not-a-number (NMin, NMax, NClamp).
std::vector<std::uint32_t> made_exact(const std::vector<std::uint32_t>& words);

}  // namespace gliftc::spirv
