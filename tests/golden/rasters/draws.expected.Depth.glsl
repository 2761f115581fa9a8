// Image<d32>, image.glift:9.
// Define DEPTH_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at DEPTH_BINDING + 1 + k.
// Optional: DEPTH_SET (the descriptor set, else 0), DEPTH_STATE (see below), DEPTH_READONLY (nothing is written).
#ifndef GLIFT_DEPTH
#define GLIFT_DEPTH 1196969447
#extension GL_EXT_scalar_block_layout : require

#ifndef DEPTH_SET
#define DEPTH_SET 0
#endif
#ifndef DEPTH_BINDING
#error define DEPTH_BINDING before this file is included
#endif
#ifdef DEPTH_READONLY
#define DEPTH_ACCESS readonly
#else
#define DEPTH_ACCESS
#endif

#ifndef DEPTH_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = DEPTH_SET, binding = DEPTH_BINDING) readonly buffer Depth_state {
    uvec2 Depth_extent;
};
#endif

layout(set = DEPTH_SET, binding = DEPTH_BINDING + 1) uniform sampler2D Depth_data;

uvec2 Depth_translate(uvec2 address) {
    return address;
}

float Depth_read(uvec2 address) {
    bool Depth_value_inside = all(lessThan(address, Depth_extent));
    float Depth_value = texelFetch(Depth_data, ivec2(Depth_value_inside ? address : uvec2(0u)), 0).x;
    return Depth_value_inside ? Depth_value : 0.0;
}

#elif GLIFT_DEPTH != 1196969447
#error the functions of another structure called Depth are included already
#endif
