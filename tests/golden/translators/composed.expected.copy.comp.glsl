#version 460
// copy, composed.glift:24: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 32, local_size_y = 8) in;

layout(push_constant, scalar) uniform Parameters {
    uvec2 f_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer F_data { float f_data[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer G_data { float g_data[]; };

void main() {
    // composed.glift:24
    uvec2 address = gl_GlobalInvocationID.xy * uvec2(1u, 2u);
    if (any(greaterThanEqual(address, f_extent))) return;
    // Each invocation takes two elements: its own, and the one in the next row if there is one.
    bool has_next = address.y + 1u < f_extent.y;
    uint f_at = address.x * f_extent.y + address.y;
    float g = f_data[f_at];
    uint f_at_1 = f_at + (has_next ? 1u : 0u);
    float g_1 = f_data[f_at_1];
    g_data[f_at] = g;
    g_data[f_at_1] = g_1;
}
