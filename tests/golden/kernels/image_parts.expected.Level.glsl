// ImageLevel<r32f>, image.glift:47.
// Define LEVEL_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at LEVEL_BINDING + 1 + k.
// Optional: LEVEL_SET (the descriptor set, else 0), LEVEL_STATE (see below), LEVEL_READONLY (nothing is written).
#ifndef GLIFT_LEVEL
#define GLIFT_LEVEL 146590233
#extension GL_EXT_scalar_block_layout : require

#ifndef LEVEL_SET
#define LEVEL_SET 0
#endif
#ifndef LEVEL_BINDING
#error define LEVEL_BINDING before this file is included
#endif
#ifdef LEVEL_READONLY
#define LEVEL_ACCESS readonly
#else
#define LEVEL_ACCESS
#endif

#ifndef LEVEL_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = LEVEL_SET, binding = LEVEL_BINDING) readonly buffer Level_state {
    uvec2 Level_data_extent;
};
#endif

layout(set = LEVEL_SET, binding = LEVEL_BINDING + 1, r32f) uniform LEVEL_ACCESS image2D Level_data;

uvec2 Level_translate(uvec2 address) {
    return address;
}

float Level_read(uvec2 address) {
    bool Level_value_inside = all(lessThan(address, Level_data_extent));
    float Level_value = imageLoad(Level_data, ivec2(Level_value_inside ? address : uvec2(0u))).x;
    return Level_value_inside ? Level_value : 0.0;
}

#ifndef LEVEL_READONLY
void Level_write(uvec2 address, float value) {
    if (all(lessThan(address, Level_data_extent))) {
        imageStore(Level_data, ivec2(address), vec4(value));
    }
}
#endif
#elif GLIFT_LEVEL != 146590233
#error the functions of another structure called Level are included already
#endif
