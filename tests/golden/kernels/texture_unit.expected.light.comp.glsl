#version 460
// light, texture_unit.glift:27: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint p_extent;
    vec2 heights_data_extent;
    uvec3 shadows_domain;
    float shadows_depths_extent_x;
    float shadows_depths_extent_y;
};

layout(scalar, set = 0, binding = 1) buffer P_data { vec3 p_data[]; };
layout(set = 0, binding = 2) uniform sampler2DArrayShadow shadows_depths_compared;
layout(set = 0, binding = 3) uniform sampler2D heights_data;
layout(set = 0, binding = 4) uniform sampler2DArray shadows_depths;

// Saturates; not-a-number gives 0.
uint to_uint(float x) {
    float safe = x >= 0.0 && x < 4294967296.0 ? x : 0.0;
    return x >= 4294967296.0 ? 4294967295u : uint(safe);
}

uvec3 to_uint(vec3 a) {
    return uvec3(to_uint(a.x), to_uint(a.y), to_uint(a.z));
}

float blend(float x, float y, float a) {
    return x * (float(1.0) - a) + y * a;
}

void main() {
    // texture_unit.glift:27
    uint address = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 512u + gl_LocalInvocationID.x;
    if (address >= p_extent) return;
    // Each invocation takes two elements: its own, and the one a workgroup's width further on if there is one.
    uint value = address + 256u;
    bool has_next = value < p_extent;
    uint next = has_next ? value : address;
    // texture_unit.glift:28
    vec3 p_value = p_data[address];
    vec2 heights_lower = p_value.xy - vec2(0.5);
    vec2 heights_corner = floor(heights_lower);
    vec4 heights_texels = textureGather(heights_data, (heights_corner + vec2(1.0))
        / heights_data_extent).wzxy;
    vec2 heights_weight = heights_lower - heights_corner;
    uvec3 shadows_address = to_uint(p_value);
    bool shadows_value_inside = all(lessThan(shadows_address, shadows_domain));
    float shadows_value = texelFetch(shadows_depths,
        ivec3(shadows_value_inside ? shadows_address : uvec3(0u)), 0).x;
    float share = textureGrad(shadows_depths_compared,
        vec4(vec3(p_value.x / shadows_depths_extent_x, p_value.y / shadows_depths_extent_y,
        floor(p_value.z)), 0.5), vec2(0.0), vec2(0.0))
        * blend(blend(p_value.z <= heights_texels.x ? 1.0 : 0.0, p_value.z <= heights_texels.y ? 1.0 : 0.0,
        heights_weight.x),
        blend(p_value.z <= heights_texels.z ? 1.0 : 0.0, p_value.z <= heights_texels.w ? 1.0 : 0.0,
        heights_weight.x), heights_weight.y) * (shadows_value_inside ? shadows_value : 0.0);
    // texture_unit.glift:29
    vec3 p = vec3(share, heights_texels.yw);
    // texture_unit.glift:28
    vec3 p_value_1 = p_data[next];
    vec2 heights_lower_1 = p_value_1.xy - vec2(0.5);
    vec2 heights_corner_1 = floor(heights_lower_1);
    vec4 heights_texels_1 = textureGather(heights_data, (heights_corner_1 + vec2(1.0))
        / heights_data_extent).wzxy;
    vec2 heights_weight_1 = heights_lower_1 - heights_corner_1;
    uvec3 shadows_address_1 = to_uint(p_value_1);
    bool shadows_value_inside_1 = all(lessThan(shadows_address_1, shadows_domain));
    float shadows_value_1 = texelFetch(shadows_depths,
        ivec3(shadows_value_inside_1 ? shadows_address_1 : uvec3(0u)), 0).x;
    float share_1 = textureGrad(shadows_depths_compared,
        vec4(vec3(p_value_1.x / shadows_depths_extent_x, p_value_1.y / shadows_depths_extent_y,
        floor(p_value_1.z)), 0.5), vec2(0.0), vec2(0.0))
        * blend(blend(p_value_1.z <= heights_texels_1.x ? 1.0 : 0.0, p_value_1.z <= heights_texels_1.y ? 1.0
        : 0.0, heights_weight_1.x),
        blend(p_value_1.z <= heights_texels_1.z ? 1.0 : 0.0, p_value_1.z <= heights_texels_1.w ? 1.0 : 0.0,
        heights_weight_1.x), heights_weight_1.y) * (shadows_value_inside_1 ? shadows_value_1 : 0.0);
    // texture_unit.glift:29
    vec3 p_1 = vec3(share_1, heights_texels_1.yw);
    p_data[address] = p;
    p_data[next] = p_1;
}
