#version 460
// gather, any.glift:9: direct form: whole structures, of equal sizes where declared with one type.
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
    uint address = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 512u + gl_LocalInvocationID.x;
    if (address >= index_extent) return;
    // Each invocation takes two elements: its own, and the one a workgroup's width further on if there is one.
    uint value = address + 256u;
    bool has_next = value < index_extent;
    uint next = has_next ? value : address;
    uint values_address = index_data[address];
    bool values_value_inside = values_address < values_extent;
    float values_value = values_data[values_value_inside ? values_address : 0u];
    uint values_address_1 = index_data[next];
    bool values_value_inside_1 = values_address_1 < values_extent;
    float values_value_1 = values_data[values_value_inside_1 ? values_address_1 : 0u];
    g_data[address] = values_value_inside ? values_value : 0.0;
    g_data[next] = values_value_inside_1 ? values_value_1 : 0.0;
}
