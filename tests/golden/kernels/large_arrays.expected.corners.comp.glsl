#version 460
// corners, large_arrays.glift:19: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_control_flow_attributes : require
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint i_extent;
};

layout(scalar, set = 0, binding = 1) writeonly buffer To_data { uint to_data[]; };

// Saturates; not-a-number gives 0.
uint to_uint(float x) {
    float safe = x >= 0.0 && x < 4294967296.0 ? x : 0.0;
    return x >= 4294967296.0 ? 4294967295u : uint(safe);
}

void main() {
    // large_arrays.glift:19
    uint address = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x;
    if (address >= i_extent) return;
    // large_arrays.glift:20
    vec3 corners[80][2];
    for (uint corners_at = 0u; corners_at < 80u; ++corners_at) {
        [[unroll]] for (uint corners_at_1 = 0u; corners_at_1 < 2u; ++corners_at_1) {
            corners[corners_at][corners_at_1] = vec3(0.0);
        }
    }
    // large_arrays.glift:21
    uint value = address % 80u;
    uint value_1 = address & 1u;
    corners[value][value_1].y += 5.0;
    // large_arrays.glift:22
    to_data[address] = to_uint(corners[value][1u].y);
}
