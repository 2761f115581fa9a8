#version 460
// halve, image_parts.glift:11: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 32, local_size_y = 8) in;

layout(push_constant, scalar) uniform Parameters {
    uvec2 fine_data_extent;
};

layout(set = 0, binding = 1) uniform sampler2D fine_data;
layout(set = 0, binding = 2, r32f) uniform writeonly image2D to_data;

void main() {
    // image_parts.glift:11
    uvec2 address = gl_GlobalInvocationID.xy * uvec2(1u, 2u);
    if (any(greaterThanEqual(address, fine_data_extent))) return;
    // Each invocation takes two elements: its own, and the one in the next row if there is one.
    uint value = address.y + 1u;
    bool has_next = value < fine_data_extent.y;
    uint next_y = has_next ? value : address.y;
    uvec2 fine_address = 2u * address;
    bool fine_value_inside = all(lessThan(fine_address, fine_data_extent));
    float fine_value = texelFetch(fine_data, ivec2(fine_value_inside ? fine_address : uvec2(0u)), 0).x;
    uvec2 value_1 = uvec2(address.x, next_y);
    uvec2 fine_address_1 = 2u * value_1;
    bool fine_value_inside_1 = all(lessThan(fine_address_1, fine_data_extent));
    float fine_value_1 = texelFetch(fine_data, ivec2(fine_value_inside_1 ? fine_address_1 : uvec2(0u)), 0).x;
    imageStore(to_data, ivec2(address), vec4(fine_value_inside ? fine_value : 0.0));
    imageStore(to_data, ivec2(value_1), vec4(fine_value_inside_1 ? fine_value_1 : 0.0));
}
