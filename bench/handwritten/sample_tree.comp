#version 460
#extension GL_EXT_scalar_block_layout : require
// Samples a quadtree of pages of 16^2 cells, whose values lie at the corners of the cells, the nodes. A page's 17^2 nodes
// are the texels of its frame; frames are in an image, 2^bits of them along x. Also writes, for the node at or before the
// point, the index of its texel within its page; zeros where no page is resident. One lookup: for each page of level 0,
// `best` holds the frame + 1 of the finest resident page that covers it, and that page's level from bit 27 on.

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint count;
    uint along;    // pages of level 0 (the finest) along an axis
    uint first;    // index in `best` of the first page of level 0
    uint bits;
    vec2 extent;   // of the image
};

layout(scalar, set = 0, binding = 1) readonly buffer P { vec2 points[]; };
layout(set = 0, binding = 2) readonly buffer Best { uint best[]; };
layout(set = 0, binding = 4) uniform sampler2D frames;
layout(scalar, set = 0, binding = 5) writeonly buffer G { vec2 g[]; };

void main() {
    uint i = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x;
    if (i >= count) return;
    vec2 node = clamp(points[i] - 0.5, 0.0, float(along << 4u));
    uvec2 low = uvec2(node);
    uvec2 page = min(low >> 4u, along - 1u);
    uint entry = best[first + page.y * along + page.x];
    uint level = entry >> 27u, frame = (entry & 0x7ffffffu) - 1u;
    uvec2 begin = (page >> level) << 4u;   // of the page's first node, counted in nodes of its level
    vec2 inside = node * uintBitsToFloat((127u - level) << 23u) - vec2(begin);
    vec2 corner = vec2(uvec2(frame & ((1u << bits) - 1u), frame >> bits) * 17u);
    float value = textureLod(frames, (corner + inside + 0.5) / extent, 0.0).x;
    uvec2 texel = (low >> level) - begin;
    g[i] = entry == 0u ? vec2(0.0) : vec2(value, float(texel.y * 17u + texel.x));
}
