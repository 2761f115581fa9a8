#version 460
// value, closures.glift:33: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

struct shift_by_first_closure_1 {
    float first;
};

layout(push_constant, scalar) uniform Parameters {
    uint first_index;
    uint result_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer First_data { float first_data[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer Result_data { shift_by_first_closure_1 result_data[]; };

void main() {
    // closures.glift:33
    uint address = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 512u + gl_LocalInvocationID.x;
    if (address >= result_extent) return;
    // Each invocation takes two elements: its own, and the one a workgroup's width further on if there is one.
    uint value = address + 256u;
    bool has_next = value < result_extent;
    uint next = has_next ? value : address;
    float first = first_data[first_index];
    shift_by_first_closure_1 result = shift_by_first_closure_1(first);
    result_data[address] = result;
    result_data[next] = result;
}
