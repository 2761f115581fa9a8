// Replaces parameters whose values are known when a pipeline is made by constants: like specialisation constants, but
// without declaring them in the shader.
#pragma once

#include <glift/pass.h>

#include <cstdint>
#include <span>
#include <vector>

namespace glift::detail {

/// The module with loads of these words of the parameter block (push constants, else the storage buffer at binding 0)
/// replaced by constants. A load that also covers a word that is not fixed stays.
std::vector<std::uint32_t> with_fixed_parameters(std::span<const std::uint32_t> spirv,
                                                 std::span<const FixedWord> fixed);

}  // namespace glift::detail
