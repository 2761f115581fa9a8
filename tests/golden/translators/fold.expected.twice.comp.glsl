#version 460
// twice, fold.glift:31: whole ranges, shared state.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 32, local_size_y = 4, local_size_z = 2) in;

layout(push_constant, scalar) uniform Parameters {
    uvec3 f_extent;
};

layout(set = 0, binding = 1, r32f) uniform image2D f_data;

void main() {
    // fold.glift:31
    uvec3 address = gl_GlobalInvocationID;
    if (any(greaterThanEqual(address, f_extent))) return;
    uint f_i = (address.z * f_extent.y + address.y) * f_extent.x + address.x;
    uvec2 f_at = uvec2(f_i % 64u, f_i / 64u);
    ivec2 value = ivec2(f_at);
    float f_value = imageLoad(f_data, value).x;
    imageStore(f_data, value, vec4(2.0 * f_value));
}
