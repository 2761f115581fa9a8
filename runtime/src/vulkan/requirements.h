// What a shader needs of a device beyond what Glift needs of every one.
#pragma once

#include <glift/device.h>

#include <cstdint>
#include <span>
#include <string>

namespace glift::detail {

/// What the shader uses and the device lacks: `subgroup shuffles, 64-bit integers`. Empty if nothing. The module itself
/// says it, by its capabilities and by the types that subgroups exchange.
std::string lacking(std::span<const std::uint32_t> spirv, const DeviceProperties& properties);

}  // namespace glift::detail
