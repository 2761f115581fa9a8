#version 460
// smooth, steps.glift:9: whole ranges, shared state.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint f_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer F_data { float f_data[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer G_data { float g_data[]; };

void main() {
    // steps.glift:9
    uint address = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x;
    if (address >= f_extent) return;
    bool f_xm1_inside = address >= 1u;
    float f_xm1 = f_data[address - (f_xm1_inside ? 1u : 0u)];
    bool f_xp1_inside = address + 1u < f_extent;
    float f_xp1 = f_data[address + (f_xp1_inside ? 1u : 0u)];
    g_data[address] = 0.25
        * ((f_xm1_inside ? f_xm1 : 0.0) + 2.0 * f_data[address] + (f_xp1_inside ? f_xp1 : 0.0));
}
