#include "float_controls.h"

namespace glift::detail {

namespace {

constexpr std::size_t header_words = 5;
constexpr std::uint32_t op_entry_point = 15, op_execution_mode = 16, op_capability = 17, op_execution_mode_id = 331;
constexpr std::uint32_t denorm_preserve = 4464, signed_zero_inf_nan_preserve = 4466,
                        rounding_mode_rte = 4467;  // capabilities
constexpr std::uint32_t mode_of(std::uint32_t capability) { return capability - 5; }

std::vector<std::uint32_t> capabilities_of(const FloatControls& controls) {
    std::vector<std::uint32_t> capabilities;
    if (controls.keep_subnormals) capabilities.push_back(denorm_preserve);
    if (controls.keep_special_values) capabilities.push_back(signed_zero_inf_nan_preserve);
    if (controls.round_to_even) capabilities.push_back(rounding_mode_rte);
    return capabilities;
}

std::uint32_t first_word(std::uint32_t op, std::uint32_t words) { return words << 16 | op; }

}  // namespace

FloatControls FloatControls::of(const VkPhysicalDeviceVulkan12Properties& properties) {
    // Where the device ties the widths together, the modes would have to be set for 64-bit floats as well.
    const bool subnormals = properties.denormBehaviorIndependence != VK_SHADER_FLOAT_CONTROLS_INDEPENDENCE_NONE;
    const bool rounding = properties.roundingModeIndependence != VK_SHADER_FLOAT_CONTROLS_INDEPENDENCE_NONE;
    return {.keep_subnormals = subnormals && properties.shaderDenormPreserveFloat32,
            .keep_special_values = properties.shaderSignedZeroInfNanPreserveFloat32 == VK_TRUE,
            .round_to_even = rounding && properties.shaderRoundingModeRTEFloat32,
            .hides_zeros = properties.driverID == VK_DRIVER_ID_MESA_LLVMPIPE};
}

std::vector<std::uint32_t> with_float_controls(std::span<const std::uint32_t> spirv, const FloatControls& controls) {
    const std::vector<std::uint32_t> capabilities = capabilities_of(controls);
    std::vector<std::uint32_t> module(spirv.begin(), spirv.begin() + header_words);
    std::vector<std::uint32_t> entry_points;
    bool capabilities_done = false, modes_done = false;
    for (std::size_t at = header_words; at < spirv.size();) {
        const std::uint32_t op = spirv[at] & 0xffffu, words = spirv[at] >> 16;
        // A module's layout: capabilities first, execution modes after the entry points.
        if (op != op_capability && !capabilities_done) {
            for (std::uint32_t capability : capabilities)
                module.insert(module.end(), {first_word(op_capability, 2), capability});
            capabilities_done = true;
        }
        if (op == op_entry_point) entry_points.push_back(spirv[at + 2]);
        if (!entry_points.empty() && op != op_entry_point && op != op_execution_mode && op != op_execution_mode_id &&
            !modes_done) {
            for (std::uint32_t entry : entry_points)
                for (std::uint32_t capability : capabilities)
                    module.insert(module.end(), {first_word(op_execution_mode, 4), entry, mode_of(capability), 32});
            modes_done = true;
        }
        module.insert(module.end(), spirv.begin() + static_cast<std::ptrdiff_t>(at),
                      spirv.begin() + static_cast<std::ptrdiff_t>(at + words));
        at += words;
    }
    return module;
}

}  // namespace glift::detail
