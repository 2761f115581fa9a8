// The program's own shader: writes into a Glift structure through functions that gliftc generated.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 8, local_size_y = 8) in;

// The state of the structure (here its extent), which functions of adopt.Picture.glsl need, in this program's push constants.
layout(push_constant, scalar) uniform Parameters {
    uvec2 Picture_extent;
    uint square;
};

#define PICTURE_STATE
#define PICTURE_BINDING 0  // the structure's first binding; its memory is at binding 1
#include "adopt.Picture.glsl"

void main() {
    uvec2 address = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(address, Picture_extent))) return;
    uvec2 place = address / square;
    Picture_write(address, float((place.x + place.y) % 2u));
}
