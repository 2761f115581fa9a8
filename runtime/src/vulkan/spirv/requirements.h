// Some of the features that a shader needs beyond those that Glift requires of every device: 16-bit and 64-bit floats,
// 64-bit integers and atomics, subgroup operations.
#pragma once

#include <glift/device.h>

#include <cstdint>
#include <span>
#include <string>

namespace glift::detail {

/// Those of these features that the shader uses and the device lacks, as text: `subgroup shuffles, 64-bit integers`.
/// Found from the module's capabilities and the types of its subgroup operations. Empty if the device lacks none.
std::string lacking(std::span<const std::uint32_t> spirv, const DeviceProperties& properties);

/// Whether the shader's result may depend on the size of its subgroups.
bool uses_subgroups(std::span<const std::uint32_t> spirv);

}  // namespace glift::detail
