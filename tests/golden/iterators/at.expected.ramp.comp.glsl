#version 460
// ramp, at.glift:8: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 32, local_size_y = 8) in;

layout(push_constant, scalar) uniform Parameters {
    uvec2 a_extent;
};

layout(scalar, set = 0, binding = 1) writeonly buffer F_data { float f_data[]; };

void main() {
    // at.glift:8
    uvec2 address = gl_GlobalInvocationID.xy * uvec2(1u, 2u);
    if (any(greaterThanEqual(address, a_extent))) return;
    // Each invocation takes two elements: its own, and the one in the next row if there is one.
    uint value = address.y + 1u;
    bool has_next = value < a_extent.y;
    uint next_y = has_next ? value : address.y;
    uint a_at = address.y * a_extent.x + address.x;
    float value_1 = float(address.x);
    float f = value_1 + 10.0 * float(address.y);
    uint a_at_1 = a_at + (has_next ? a_extent.x : 0u);
    float f_1 = value_1 + 10.0 * float(next_y);
    f_data[a_at] = f;
    f_data[a_at_1] = f_1;
}
