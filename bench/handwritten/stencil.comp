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
    bool has_right = p.x + 1u < extent.x, has_left = p.x > 0u, has_below = p.y + 1u < extent.y, has_above = p.y > 0u;
    // Always a load, never a branch.
    float right = f[has_right ? place(p.x + 1u, p.y) : i];
    float left = f[has_left ? place(p.x - 1u, p.y) : i];
    float below = f[has_below ? place(p.x, p.y + 1u) : i];
    float above = f[has_above ? place(p.x, p.y - 1u) : i];
    precise float value =
        0.25 * ((has_right ? right : 0.0) + (has_left ? left : 0.0) + (has_below ? below : 0.0) + (has_above ? above : 0.0)) - f[i];
    g[i] = value;
}
