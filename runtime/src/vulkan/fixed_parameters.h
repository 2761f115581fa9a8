// Parameters whose values are known when a pipeline is made become constants of its shader: what a specialisation
// constant does, in the shader as it is.
#pragma once

#include <glift/pass.h>

#include <cstdint>
#include <span>
#include <vector>

namespace glift::detail {

/// The module with loads of these words of the parameter block (push constants, else the storage buffer at binding 0)
/// made constants. What it loads together with a word that is not fixed it goes on loading.
std::vector<std::uint32_t> with_fixed_parameters(std::span<const std::uint32_t> spirv,
                                                 std::span<const FixedWord> fixed);

}  // namespace glift::detail
