#version 460
// value, device_values.glift:16: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint n_index;
    uint result_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer N_data { uint n_data[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer Result_data { bool result_data[]; };

void main() {
    // device_values.glift:16
    uint address = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 512u + gl_LocalInvocationID.x;
    if (address >= result_extent) return;
    // Each invocation takes two elements: its own, and the one a workgroup's width further on if there is one.
    uint value = address + 256u;
    bool has_next = value < result_extent;
    uint next = has_next ? value : address;
    uint n = n_data[n_index];
    bool result = n > 3u;
    result_data[address] = result;
    result_data[next] = result;
}
