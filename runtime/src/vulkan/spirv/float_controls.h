// SPIR-V execution modes that make float arithmetic the same on every device, where the device has them.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <span>
#include <vector>

namespace glift::detail {

/// A mode for floats of one width.
struct FloatMode {
    std::uint32_t capability;  ///< DenormPreserve, SignedZeroInfNanPreserve or RoundingModeRTE
    std::uint32_t width;       ///< 16, 32 or 64
};

struct FloatControls {
    /// The modes to set, of those that the device has: keep subnormals; keep signed zeros, infinities and NaN; round to
    /// nearest even (on NVIDIA's driver not for 32 bits: float_controls.cpp says why).
    std::vector<FloatMode> modes;
    bool hides_zeros = false;  ///< the driver simplifies constant zeros in spite of the modes: see hidden_zeros.h
    bool keeps_sums = false;   ///< the driver rounds differences of constants wrongly: see exact_sums.h

    static FloatControls of(const VkPhysicalDeviceVulkan12Properties& properties);
};

/// Adds these modes to each entry point of the module, which must be SPIR-V 1.4 or later: older versions need an
/// extension for them, which is not declared.
std::vector<std::uint32_t> with_float_modes(std::span<const std::uint32_t> spirv, std::span<const FloatMode> modes);

}  // namespace glift::detail
