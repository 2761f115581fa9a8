#version 460
// copy, composed.glift:24: whole ranges, shared state.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 32, local_size_y = 8) in;

layout(push_constant, scalar) uniform Parameters {
    uvec2 f_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer F_data { float f_data[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer G_data { float g_data[]; };

void main() {
    // composed.glift:24
    uvec2 address = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(address, f_extent))) return;
    uint f_at = address.x * f_extent.y + address.y;
    g_data[f_at] = f_data[f_at];
}
