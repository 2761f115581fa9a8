#include "float_controls.h"

#include "spirv_module.h"

#include <array>
#include <set>

namespace glift::detail {

namespace {

constexpr std::uint32_t denorm_preserve = 4464, signed_zero_inf_nan_preserve = 4466,
                        rounding_mode_rte = 4467;  // capabilities
constexpr std::uint32_t mode_of(std::uint32_t capability) { return capability - 5; }

/// Whether a device has a mode for floats of 16, 32 and 64 bits.
using Widths = std::array<bool, 3>;

/// Leaves out widths that the device can only set together with other widths, if it lacks the mode for one of the
/// latter.
Widths allowed(Widths widths, VkShaderFloatControlsIndependence independence) {
    auto& [half, single, full] = widths;
    if (independence == VK_SHADER_FLOAT_CONTROLS_INDEPENDENCE_NONE && !(half && single && full)) return {};
    if (independence == VK_SHADER_FLOAT_CONTROLS_INDEPENDENCE_32_BIT_ONLY && half != full) half = full = false;
    return widths;
}

void add(std::vector<FloatMode>& modes, std::uint32_t capability, Widths widths) {
    for (std::uint32_t i = 0; i < widths.size(); ++i)
        if (widths[i]) modes.push_back({capability, 16u << i});
}

}  // namespace

FloatControls FloatControls::of(const VkPhysicalDeviceVulkan12Properties& properties) {
    auto has = [](VkBool32 half, VkBool32 single, VkBool32 full) { return Widths{half != 0, single != 0, full != 0}; };
    FloatControls controls{.modes = {},
                           .hides_zeros = properties.driverID == VK_DRIVER_ID_MESA_LLVMPIPE,
                           .keeps_sums = properties.driverID == VK_DRIVER_ID_NVIDIA_PROPRIETARY};
    // NVIDIA's driver has DenormPreserve for 16 bits only, but with it keeps subnormal numbers of 32 bits, too. Without
    // it, comparisons, `sign` and conversions treat them as zeros (seen on an H200, driver 580).
    add(controls.modes, denorm_preserve,
        allowed(has(properties.shaderDenormPreserveFloat16, properties.shaderDenormPreserveFloat32,
                    properties.shaderDenormPreserveFloat64),
                properties.denormBehaviorIndependence));
    add(controls.modes, signed_zero_inf_nan_preserve,
        has(properties.shaderSignedZeroInfNanPreserveFloat16, properties.shaderSignedZeroInfNanPreserveFloat32,
            properties.shaderSignedZeroInfNanPreserveFloat64));
    // With RoundingModeRTE for 32 bits, NVIDIA's driver (580, seen on an H100) divides floats by a subroutine, with
    // which a shader that also used 64-bit integers did not end. Its sums and products are rounded to even without it,
    // and the quotients that generated shaders correct (gliftc, division.cpp) may be approximations.
    const bool rounds_single =
        properties.shaderRoundingModeRTEFloat32 && properties.driverID != VK_DRIVER_ID_NVIDIA_PROPRIETARY;
    add(controls.modes, rounding_mode_rte,
        allowed(has(properties.shaderRoundingModeRTEFloat16, rounds_single, properties.shaderRoundingModeRTEFloat64),
                properties.roundingModeIndependence));
    return controls;
}

std::vector<std::uint32_t> with_float_modes(std::span<const std::uint32_t> spirv, std::span<const FloatMode> modes) {
    std::set<std::uint32_t> capabilities;
    for (const FloatMode& mode : modes) capabilities.insert(mode.capability);
    std::vector<std::uint32_t> module(spirv.begin(), spirv.begin() + spirv_header_words);
    std::vector<std::uint32_t> entry_points;
    bool capabilities_done = false, modes_done = false;
    for (std::size_t at = spirv_header_words; at < spirv.size();) {
        const std::uint32_t op = spirv[at] & 0xffffu, words = spirv[at] >> 16;
        // A module's layout: capabilities first, execution modes after the entry points.
        if (op != spirv::capability && !capabilities_done) {
            for (std::uint32_t capability : capabilities)
                module.insert(module.end(), {first_word(spirv::capability, 2), capability});
            capabilities_done = true;
        }
        if (op == spirv::entry_point) entry_points.push_back(spirv[at + 2]);
        if (!entry_points.empty() && op != spirv::entry_point && op != spirv::execution_mode &&
            op != spirv::execution_mode_id && !modes_done) {
            for (std::uint32_t entry : entry_points)
                for (const FloatMode& mode : modes)
                    module.insert(module.end(),
                                  {first_word(spirv::execution_mode, 4), entry, mode_of(mode.capability), mode.width});
            modes_done = true;
        }
        module.insert(module.end(), spirv.begin() + static_cast<std::ptrdiff_t>(at),
                      spirv.begin() + static_cast<std::ptrdiff_t>(at + words));
        at += words;
    }
    return module;
}

}  // namespace glift::detail
