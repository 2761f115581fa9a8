// Shadows, texture_unit.glift:7.
// Define SHADOWS_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at SHADOWS_BINDING + 1 + k.
// Optional: SHADOWS_SET (the descriptor set, else 0), SHADOWS_STATE (see below), SHADOWS_READONLY (nothing is written).
#ifndef GLIFT_SHADOWS
#define GLIFT_SHADOWS 958551079
#extension GL_EXT_scalar_block_layout : require

#ifndef SHADOWS_SET
#define SHADOWS_SET 0
#endif
#ifndef SHADOWS_BINDING
#error define SHADOWS_BINDING before this file is included
#endif
#ifdef SHADOWS_READONLY
#define SHADOWS_ACCESS readonly
#else
#define SHADOWS_ACCESS
#endif

#ifndef SHADOWS_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = SHADOWS_SET, binding = SHADOWS_BINDING) readonly buffer Shadows_state {
    uvec2 Shadows_extent;
    uint Shadows_layers;
};
#endif

layout(set = SHADOWS_SET, binding = SHADOWS_BINDING + 1) uniform sampler2DArray Shadows_depths;

uvec3 Shadows_translate(uvec3 address) {
    return address;
}

float Shadows_read(uvec3 address) {
    bool Shadows_value_inside = all(lessThan(address, uvec3(Shadows_extent, Shadows_layers)));
    float Shadows_value = texelFetch(Shadows_depths, ivec3(Shadows_value_inside ? address : uvec3(0u)), 0).x;
    return Shadows_value_inside ? Shadows_value : 0.0;
}

#elif GLIFT_SHADOWS != 958551079
#error the functions of another structure called Shadows are included already
#endif
