// Image<rgba8>, image.glift:9.
// Define COLOUR_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at COLOUR_BINDING + 1 + k.
// Optional: COLOUR_SET (the descriptor set, else 0), COLOUR_STATE (see below), COLOUR_READONLY (nothing is written).
#ifndef GLIFT_COLOUR
#define GLIFT_COLOUR 1760192777
#extension GL_EXT_scalar_block_layout : require

#ifndef COLOUR_SET
#define COLOUR_SET 0
#endif
#ifndef COLOUR_BINDING
#error define COLOUR_BINDING before this file is included
#endif
#ifdef COLOUR_READONLY
#define COLOUR_ACCESS readonly
#else
#define COLOUR_ACCESS
#endif

#ifndef COLOUR_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = COLOUR_SET, binding = COLOUR_BINDING) readonly buffer Colour_state {
    uvec2 Colour_extent;
};
#endif

layout(set = COLOUR_SET, binding = COLOUR_BINDING + 1, rgba8) uniform COLOUR_ACCESS image2D Colour_data;

uvec2 Colour_translate(uvec2 address) {
    return address;
}

vec4 Colour_read(uvec2 address) {
    bool Colour_value_inside = all(lessThan(address, Colour_extent));
    vec4 Colour_value = imageLoad(Colour_data, ivec2(Colour_value_inside ? address : uvec2(0u)));
    return Colour_value_inside ? Colour_value : vec4(0.0);
}

#ifndef COLOUR_READONLY
void Colour_write(uvec2 address, vec4 value) {
    if (all(lessThan(address, Colour_extent))) {
        imageStore(Colour_data, ivec2(address), value);
    }
}
#endif
#elif GLIFT_COLOUR != 1760192777
#error the functions of another structure called Colour are included already
#endif
