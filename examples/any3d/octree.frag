// A fragment shader of the program's own: the octree at the centres of a plane's elements, by the function that gliftc wrote.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

// The octree's state, which any3d.Octree.glsl needs, in this program's push constants.
layout(push_constant, scalar) uniform Parameters {
    uint Octree_levels;
    uint Octree_best_extent;
    uint Octree_pages_capacity;
    uvec3 Octree_frames_texels_extent;
    uvec3 Octree_frames_texels_data_extent;
    float z;
};

#define OCTREE_STATE
#define OCTREE_READONLY
#define OCTREE_BINDING 0  // the structure's first binding; its memories are at 1 (the page table) and 2 (the frames)
#include "any3d.Octree.glsl"

layout(location = 0) out vec4 colour;

void main() { colour = Octree_sample(vec3(gl_FragCoord.xy, z)); }
