#version 460
// Listed.blocks, blocks.glift:16: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint result_extent;
    uint self_state_value_inside;
    bool self_state_value_inside_2;
    uint self_capacity;
};

layout(scalar, set = 0, binding = 1) readonly buffer Self_state_data { uint self_state_data[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer Result_data { uint result_data[]; };

void main() {
    // blocks.glift:16
    uint address = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 512u + gl_LocalInvocationID.x;
    if (address >= result_extent) return;
    // Each invocation takes two elements: its own, and the one a workgroup's width further on if there is one.
    uint value = address + 256u;
    bool has_next = value < result_extent;
    uint next = has_next ? value : address;
    uint self_state_value = self_state_data[self_state_value_inside];
    uint result = min(self_state_value_inside_2 ? self_state_value : 0u, self_capacity);
    result_data[address] = result;
    result_data[next] = result;
}
