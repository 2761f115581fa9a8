// Picture, own_functions.glift:28.
// Define PICTURE_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at PICTURE_BINDING + 1 + k.
// Optional: PICTURE_SET (the descriptor set, else 0), PICTURE_STATE (see below), PICTURE_READONLY (nothing is written).
#ifndef GLIFT_PICTURE
#define GLIFT_PICTURE 189417518
#extension GL_EXT_scalar_block_layout : require

#ifndef PICTURE_SET
#define PICTURE_SET 0
#endif
#ifndef PICTURE_BINDING
#error define PICTURE_BINDING before this file is included
#endif
#ifdef PICTURE_READONLY
#define PICTURE_ACCESS readonly
#else
#define PICTURE_ACCESS
#endif

#ifndef PICTURE_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = PICTURE_SET, binding = PICTURE_BINDING) readonly buffer Picture_state {
    uvec2 Picture_texels_extent;
    uvec2 Picture_extent;
};
#endif

layout(set = PICTURE_SET, binding = PICTURE_BINDING + 1, rgba8) uniform PICTURE_ACCESS image2D Picture_texels_data;

bool Picture_is_mapped(uvec2 address) {
    return all(lessThan(address, Picture_texels_extent));
}

uvec2 Picture_translate(uvec2 address) {
    return address;
}

vec4 Picture_read(uvec2 address) {
    bool Picture_value_inside = all(lessThan(address, Picture_texels_extent));
    vec4 Picture_value = imageLoad(Picture_texels_data, ivec2(Picture_value_inside ? address : uvec2(0u)));
    return Picture_value_inside ? Picture_value : vec4(0.0);
}

uint Picture_width() {
    return Picture_extent.x;
}

#ifndef PICTURE_READONLY
void Picture_write(uvec2 address, vec4 value) {
    if (all(lessThan(address, Picture_texels_extent))) {
        imageStore(Picture_texels_data, ivec2(address), value);
    }
}
#endif
#elif GLIFT_PICTURE != 189417518
#error the functions of another structure called Picture are included already
#endif
