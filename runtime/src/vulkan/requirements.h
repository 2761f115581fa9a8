// Features that a shader needs beyond those that Glift requires of every device.
#pragma once

#include <glift/device.h>

#include <cstdint>
#include <span>
#include <string>

namespace glift::detail {

/// Features that the shader uses and the device lacks, as text: `subgroup shuffles, 64-bit integers`. Found from the
/// module's capabilities and the types of its subgroup operations. Empty if none.
std::string lacking(std::span<const std::uint32_t> spirv, const DeviceProperties& properties);

}  // namespace glift::detail
