#version 460
#extension GL_EXT_scalar_block_layout : require
// Random reads through a page table, as read_pages.comp, but the size of the table's pages is a parameter; zero outside
// and where no page is resident.

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint count;
    uvec3 extent;
    uvec3 size;    // of a page
    uvec2 pages;   // along x and y
    uvec2 bits;
};

layout(scalar, set = 0, binding = 1) readonly buffer P { uvec3 places[]; };
layout(set = 0, binding = 2) readonly buffer Table { uint table[]; };
layout(set = 0, binding = 3) uniform sampler3D frames;
layout(set = 0, binding = 4) writeonly buffer G { float g[]; };

void main() {
    uint i = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x;
    if (i >= count) return;
    uvec3 p = places[i];
    bool inside = all(lessThan(p, extent));
    uvec3 page = p / size, o = p - page * size;
    uint entry = table[inside ? (page.z * pages.y + page.y) * pages.x + page.x : 0u];
    bool there = inside && entry != 0u;
    uint frame = there ? entry - 1u : 0u;
    uvec3 place = uvec3(frame & ((1u << bits.x) - 1u), frame >> bits.x & ((1u << bits.y) - 1u), frame >> (bits.x + bits.y));
    uint element = (o.z * size.y + o.y) * size.x + o.x;   // row-major in its page; all frames are stored as 8^3
    uvec3 texel = place << 3u | uvec3(element & 7u, element >> 3u & 7u, element >> 6u & 7u);
    float value = texelFetch(frames, ivec3(texel), 0).x;
    g[i] = there ? value : 0.0;
}
