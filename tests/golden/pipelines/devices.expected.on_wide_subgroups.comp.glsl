#version 460
// on_wide_subgroups, devices.glift:20: whole ranges, shared state.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint to_extent;
};

layout(scalar, set = 0, binding = 1) writeonly buffer To_data { uint to_data[]; };

void main() {
    // devices.glift:20
    uint address = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x;
    if (address >= to_extent) return;
    // devices.glift:21
    to_data[address] = 5u;
}
