#version 460
// smooth, steps.glift:9: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint f_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer F_data { float f_data[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer G_data { float g_data[]; };

void main() {
    // steps.glift:9
    uint address = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 512u + gl_LocalInvocationID.x;
    if (address >= f_extent) return;
    // Each invocation takes two elements: its own, and the one a workgroup's width further on if there is one.
    uint value = address + 256u;
    bool has_next = value < f_extent;
    uint next = has_next ? value : address;
    bool f_xm1_inside = address >= 1u;
    float f_xm1 = f_data[address - (f_xm1_inside ? 1u : 0u)];
    uint f_xp1_at = address + 1u;
    bool f_xp1_inside = f_xp1_at < f_extent;
    float f_xp1 = f_data[f_xp1_inside ? f_xp1_at : address];
    float g = 0.25 * ((f_xm1_inside ? f_xm1 : 0.0) + 2.0 * f_data[address] + (f_xp1_inside ? f_xp1 : 0.0));
    bool f_xm1_inside_1 = next >= 1u;
    float f_xm1_1 = f_data[next - (f_xm1_inside_1 ? 1u : 0u)];
    uint f_xp1_at_1 = next + 1u;
    bool f_xp1_inside_1 = f_xp1_at_1 < f_extent;
    float f_xp1_1 = f_data[f_xp1_inside_1 ? f_xp1_at_1 : next];
    float g_1 = 0.25
        * ((f_xm1_inside_1 ? f_xm1_1 : 0.0) + 2.0 * f_data[next] + (f_xp1_inside_1 ? f_xp1_1 : 0.0));
    g_data[address] = g;
    g_data[next] = g_1;
}
