// Execution modes that make floats the same on every device, where the device has them.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <span>
#include <vector>

namespace glift::detail {

/// What a device offers for 32-bit floats.
struct FloatControls {
    bool keep_subnormals = false;      ///< shaderDenormPreserveFloat32
    bool keep_special_values = false;  ///< shaderSignedZeroInfNanPreserveFloat32: zeros have signs, infinities stay
    bool round_to_even = false;        ///< shaderRoundingModeRTEFloat32
    bool hides_zeros = false;          ///< constant zeros are simplified all the same: see hidden_zeros.h

    static FloatControls of(const VkPhysicalDeviceVulkan12Properties& properties);
};

/// The module with these modes asked for at each of its entry points. SPIR-V 1.4 or later.
std::vector<std::uint32_t> with_float_controls(std::span<const std::uint32_t> spirv, const FloatControls& controls);

}  // namespace glift::detail
