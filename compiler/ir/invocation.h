// Built-in inputs: ids of an invocation in kernels and shaders, and properties of the device in pipelines.
#pragma once

#include <cstdint>

namespace gliftc::ir {

/// Ids and sizes within a kernel with a group; all uint.
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

/// Built-in inputs of shaders in lowered passes.
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
    corner,          // uint: the vertex index
    instance,        // uint: the instance index
    fragment_place,  // float4: the pixel's centre in the framebuffer, depth, 1 / w
    is_front,        // bool
    skips_branches,  // bool, a specialisation constant: the device does not execute a branch that no lane takes
    adds_floats,     // bool, a specialisation constant: the device adds floats by one atomic operation
};

}  // namespace gliftc::ir
