// Image<rgba8>, image.glift:9.
// Define before including: COLOUR_BINDING (the state; memory k follows at + 1 + k). Where wanted: COLOUR_SET, COLOUR_STATE, COLOUR_READONLY.
#ifndef GLIFT_COLOUR
#define GLIFT_COLOUR 1468926147
#extension GL_EXT_scalar_block_layout : require

#ifndef COLOUR_SET
#define COLOUR_SET 0
#endif
#if !defined COLOUR_BINDING && !defined COLOUR_STATE
#error define COLOUR_BINDING before this file is included
#endif
#ifdef COLOUR_READONLY
#define COLOUR_ACCESS readonly
#else
#define COLOUR_ACCESS
#endif

#ifndef COLOUR_STATE  // define it where the members below are declared in a block of your own
layout(scalar, set = COLOUR_SET, binding = COLOUR_BINDING) readonly buffer Colour_state {
    uvec2 Colour_extent;
};
#endif

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
#elif GLIFT_COLOUR != 1468926147
#error the functions of another structure called Colour are included already
#endif
