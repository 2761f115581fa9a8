#version 460
// gather, any.glift:9: whole ranges, shared state.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint index_extent;
    uint values_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer Index_data { uint index_data[]; };
layout(scalar, set = 0, binding = 2) readonly buffer Values_data { float values_data[]; };
layout(scalar, set = 0, binding = 3) writeonly buffer G_data { float g_data[]; };

void main() {
    // any.glift:9
    uint address = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x;
    if (address >= index_extent) return;
    uint values_address = index_data[address];
    bool values_value_inside = values_address < values_extent;
    float values_value = values_data[values_value_inside ? values_address : 0u];
    g_data[address] = values_value_inside ? values_value : 0.0;
}
