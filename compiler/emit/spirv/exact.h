// Makes float arithmetic of a SPIR-V module give the same results on every device.
#pragma once

#include <cstdint>
#include <vector>

namespace gliftc::spirv {

/// Decorates the results of all float arithmetic NoContraction, so that no device fuses a multiplication with an
/// addition, and replaces FMin, FMax and FClamp by NMin, NMax and NClamp, which are defined for not-a-number.
std::vector<std::uint32_t> made_exact(const std::vector<std::uint32_t>& words);

}  // namespace gliftc::spirv
