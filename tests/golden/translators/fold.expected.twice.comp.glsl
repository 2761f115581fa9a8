#version 460
// twice, fold.glift:31: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 32, local_size_y = 4, local_size_z = 2) in;

layout(push_constant, scalar) uniform Parameters {
    uvec3 f_extent;
};

layout(set = 0, binding = 1, r32f) uniform image2D f_data;

void main() {
    // fold.glift:31
    uvec3 address = gl_GlobalInvocationID * uvec3(1u, 2u, 1u);
    if (any(greaterThanEqual(address, f_extent))) return;
    // Each invocation takes two elements: its own, and the one in the next row if there is one.
    bool has_next = address.y + 1u < f_extent.y;
    uint f_i = (address.z * f_extent.y + address.y) * f_extent.x + address.x;
    uvec2 f_at = uvec2(f_i % 64u, f_i / 64u);
    ivec2 value = ivec2(f_at);
    float f_value = imageLoad(f_data, value).x;
    float f = 2.0 * f_value;
    uint f_i_1 = f_i + (has_next ? f_extent.x : 0u);
    uvec2 f_at_1 = uvec2(f_i_1 % 64u, f_i_1 / 64u);
    ivec2 value_1 = ivec2(f_at_1);
    float f_value_1 = imageLoad(f_data, value_1).x;
    float f_1 = 2.0 * f_value_1;
    imageStore(f_data, value, vec4(f));
    imageStore(f_data, value_1, vec4(f_1));
}
