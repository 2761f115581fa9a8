#version 460
// Five points of a 2-D array in tiles of 8 by 8, each tile contiguous; zero outside.

layout(local_size_x = 32, local_size_y = 8) in;

layout(push_constant) uniform Parameters {
    uvec2 extent;
    uint tiles;   // along x
};

layout(set = 0, binding = 1) readonly buffer F { float f[]; };
layout(set = 0, binding = 2) writeonly buffer G { float g[]; };

uint place(uint x, uint y) {
    return ((y >> 3) * tiles + (x >> 3)) * 64u + (y & 7u) * 8u + (x & 7u);
}

void main() {
    uvec2 p = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(p, extent))) return;
    uint i = place(p.x, p.y);
    float right = p.x + 1u < extent.x ? f[place(p.x + 1u, p.y)] : 0.0;
    float left = p.x > 0u ? f[place(p.x - 1u, p.y)] : 0.0;
    float below = p.y + 1u < extent.y ? f[place(p.x, p.y + 1u)] : 0.0;
    float above = p.y > 0u ? f[place(p.x, p.y - 1u)] : 0.0;
    g[i] = 0.25 * (right + left + below + above) - f[i];
}
