// ImageLevels<r32f>, image.glift:36.
// Define LEVELS_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at LEVELS_BINDING + 1 + k.
// Optional: LEVELS_SET (the descriptor set, else 0), LEVELS_STATE (see below), LEVELS_READONLY (nothing is written).
#ifndef GLIFT_LEVELS
#define GLIFT_LEVELS 59129377
#extension GL_EXT_scalar_block_layout : require

#ifndef LEVELS_SET
#define LEVELS_SET 0
#endif
#ifndef LEVELS_BINDING
#error define LEVELS_BINDING before this file is included
#endif
#ifdef LEVELS_READONLY
#define LEVELS_ACCESS readonly
#else
#define LEVELS_ACCESS
#endif

#ifndef LEVELS_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = LEVELS_SET, binding = LEVELS_BINDING) readonly buffer Levels_state {
    uvec2 Levels_extent;
};
#endif

layout(set = LEVELS_SET, binding = LEVELS_BINDING + 1, r32f) uniform LEVELS_ACCESS image2D Levels_data;

uvec2 Levels_translate(uvec2 address) {
    return address;
}

float Levels_read(uvec2 address) {
    bool Levels_value_inside = all(lessThan(address, Levels_extent));
    float Levels_value = imageLoad(Levels_data, ivec2(Levels_value_inside ? address : uvec2(0u))).x;
    return Levels_value_inside ? Levels_value : 0.0;
}

#ifndef LEVELS_READONLY
void Levels_write(uvec2 address, float value) {
    if (all(lessThan(address, Levels_extent))) {
        imageStore(Levels_data, ivec2(address), vec4(value));
    }
}
#endif
#elif GLIFT_LEVELS != 59129377
#error the functions of another structure called Levels are included already
#endif
