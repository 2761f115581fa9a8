#version 460
// on_wide_subgroups, devices.glift:20: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint to_extent;
};

layout(scalar, set = 0, binding = 1) writeonly buffer To_data { uint to_data[]; };

void main() {
    // devices.glift:20
    uint address = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 512u + gl_LocalInvocationID.x;
    if (address >= to_extent) return;
    // Each invocation takes two elements: its own, and the one a workgroup's width further on if there is one.
    uint value = address + 256u;
    bool has_next = value < to_extent;
    uint next = has_next ? value : address;
    // devices.glift:21
    to_data[address] = 5u;
    to_data[next] = 5u;
}
