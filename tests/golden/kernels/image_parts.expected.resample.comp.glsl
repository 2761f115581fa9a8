#version 460
// resample, image_parts.glift:13: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 32, local_size_y = 8) in;

layout(push_constant, scalar) uniform Parameters {
    uvec2 a_data_extent;
    vec2 from_data_extent;
    float level;
    float layers_data_extent_x;
    float layers_data_extent_y;
};

layout(set = 0, binding = 1) uniform sampler2D from_data;
layout(set = 0, binding = 2) uniform sampler2DArray layers_data;
layout(set = 0, binding = 3, rgba8) uniform writeonly image2D to_data;

void main() {
    // image_parts.glift:13
    uvec2 address = gl_GlobalInvocationID.xy * uvec2(1u, 2u);
    if (any(greaterThanEqual(address, a_data_extent))) return;
    // Each invocation takes two elements: its own, and the one in the next row if there is one.
    uint value = address.y + 1u;
    bool has_next = value < a_data_extent.y;
    uint next_y = has_next ? value : address.y;
    // image_parts.glift:14
    vec2 from_point = vec2(address);
    vec3 layers_point = vec3(from_point, 1.5);
    vec4 to = textureLod(from_data, from_point / from_data_extent, level).x
        * textureLod(layers_data,
        vec3(layers_point.x / layers_data_extent_x, layers_point.y / layers_data_extent_y,
        floor(layers_point.z)), 0.0);
    uvec2 value_1 = uvec2(address.x, next_y);
    vec2 from_point_1 = vec2(value_1);
    vec3 layers_point_1 = vec3(from_point_1, 1.5);
    vec4 to_1 = textureLod(from_data, from_point_1 / from_data_extent, level).x
        * textureLod(layers_data,
        vec3(layers_point_1.x / layers_data_extent_x, layers_point_1.y / layers_data_extent_y,
        floor(layers_point_1.z)), 0.0);
    imageStore(to_data, ivec2(address), to);
    imageStore(to_data, ivec2(value_1), to_1);
}
