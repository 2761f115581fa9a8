// Removes from SPIR-V what no driver needs.
#pragma once

#include <cstdint>
#include <vector>

namespace gliftc::spirv {

/// The module without names, line numbers, and the texts that these refer to.
std::vector<std::uint32_t> without_debug_info(const std::vector<std::uint32_t>& words);

}  // namespace gliftc::spirv
