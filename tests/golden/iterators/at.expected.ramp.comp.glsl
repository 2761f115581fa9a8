#version 460
// ramp, at.glift:8: whole ranges, shared state.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 32, local_size_y = 8) in;

layout(push_constant, scalar) uniform Parameters {
    uvec2 a_extent;
};

layout(scalar, set = 0, binding = 1) writeonly buffer F_data { float f_data[]; };

void main() {
    // at.glift:8
    uvec2 address = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(address, a_extent))) return;
    uint a_at = address.y * a_extent.x + address.x;
    f_data[a_at] = float(address.x) + 10.0 * float(address.y);
}
