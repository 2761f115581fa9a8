// What an invocation is told about itself, and a pipeline about its device.
#pragma once

#include <cstdint>

namespace gliftc::ir {

/// Ids within a grouped kernel; all uint.
enum class Invocation : std::uint8_t {
    local_index,
    group_index,
    group_count,
    group_size,
    subgroup_size,
    subgroup_lane,
    subgroup_index,
    subgroup_count
};

/// Properties of the device that a pipeline can query, to choose between variants of an algorithm.
enum class DeviceProperty : std::uint8_t {
    is_host,
    is_gpu,
    subgroup_size,
    subgroup_arithmetic,
    int64,
    shared_memory_bytes
};

/// Built-in inputs of shaders; only made by lower/dispatch and lower/raster.
enum class Builtin : std::uint8_t {
    global_id,
    local_id,
    group_id,
    group_count,
    local_index,
    subgroup_size,
    subgroup_lane,
    subgroup_index,
    subgroup_count,
    corner,          // uint: number of the corner
    instance,        // uint
    fragment_place,  // float4: the pixel's centre in the framebuffer, depth, 1 / w
    is_front,        // bool
    skips_branches,  // bool, of the device: a branch that no lane takes costs nothing
};

}  // namespace gliftc::ir
