#version 460
// scale, device_values.glift:8: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint a_extent;
    uint by;
};

layout(scalar, set = 0, binding = 1) buffer A_data { uint a_data[]; };

void main() {
    // device_values.glift:8
    uint address = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 512u + gl_LocalInvocationID.x;
    if (address >= a_extent) return;
    // Each invocation takes two elements: its own, and the one a workgroup's width further on if there is one.
    uint value = address + 256u;
    bool has_next = value < a_extent;
    uint next = has_next ? value : address;
    // device_values.glift:9
    uint a_value = a_data[address];
    uint a = a_value * by;
    uint a_value_1 = a_data[next];
    uint a_1 = a_value_1 * by;
    a_data[address] = a;
    a_data[next] = a_1;
}
