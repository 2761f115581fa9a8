// Atomic sums of floats in buffers and workgroup memory, for devices that have none.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace glift::detail {

/// The module without atomic sums of floats but in images, and without the capability for them unless it adds floats in
/// images. Generated shaders have such sums only where the specialisation constant `adds_floats` is true
/// (shader_stage.cpp).
std::vector<std::uint32_t> without_float_atomics(std::span<const std::uint32_t> spirv);

}  // namespace glift::detail
