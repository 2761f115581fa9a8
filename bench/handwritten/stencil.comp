#version 460
// A five-point stencil of a 2-D array in tiles of 8 by 8, each tile contiguous; zero outside. An invocation takes two
// elements that are neighbours along y.

layout(local_size_x = 32, local_size_y = 8) in;

layout(push_constant) uniform Parameters {
    uvec2 extent;
    uint tiles;   // tiles along x
};

layout(set = 0, binding = 1) readonly buffer F { float f[]; };
layout(set = 0, binding = 2) writeonly buffer G { float g[]; };

uint place(uint x, uint y) {
    return ((y >> 3) * tiles + (x >> 3)) * 64u + (y & 7u) * 8u + (x & 7u);
}

void main() {
    uvec2 p = gl_GlobalInvocationID.xy * uvec2(1u, 2u);
    if (any(greaterThanEqual(p, extent))) return;
    bool has_right = p.x + 1u < extent.x, has_left = p.x > 0u, has_above = p.y > 0u;
    bool has_next = p.y + 1u < extent.y, has_below = p.y + 2u < extent.y;
    // Loads are unconditional. Addresses are computed first, since compilers branch around a call inside ?:.
    uint next_y = has_next ? p.y + 1u : p.y;
    uint i = place(p.x, p.y), i_right = place(p.x + 1u, p.y), i_left = place(p.x - 1u, p.y);
    uint j = place(p.x, next_y), j_right = place(p.x + 1u, next_y), j_left = place(p.x - 1u, next_y);
    uint i_above = place(p.x, p.y - 1u), j_below = place(p.x, p.y + 2u);
    float right = f[has_right ? i_right : i], left = f[has_left ? i_left : i];
    float next_centre = f[j], above = f[has_above ? i_above : i], centre = f[i];  // centres: neighbours of each other
    float next_right = f[has_right ? j_right : j], next_left = f[has_left ? j_left : j];
    float below = f[has_below ? j_below : j];
    precise float value = 0.25 * ((has_right ? right : 0.0) + (has_left ? left : 0.0) + (has_next ? next_centre : 0.0) +
                                  (has_above ? above : 0.0)) - centre;
    precise float next = 0.25 * ((has_right ? next_right : 0.0) + (has_left ? next_left : 0.0) + (has_below ? below : 0.0) +
                                 centre) - next_centre;
    g[i] = value;
    if (has_next) g[j] = next;
}
