// SPIR-V execution modes that make float arithmetic the same on every device, where the device has them.
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
    bool hides_zeros = false;          ///< the driver simplifies constant zeros even so: see hidden_zeros.h

    static FloatControls of(const VkPhysicalDeviceVulkan12Properties& properties);
};

/// Adds these modes to each entry point of the module. SPIR-V 1.4 or later.
std::vector<std::uint32_t> with_float_controls(std::span<const std::uint32_t> spirv, const FloatControls& controls);

}  // namespace glift::detail
