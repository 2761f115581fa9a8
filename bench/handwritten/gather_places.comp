#version 460
#extension GL_EXT_scalar_block_layout : require
// Random reads of a 3-D array in Morton order; zero outside. An invocation takes two elements, a workgroup's width apart.

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint count;
    uvec3 extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer P { uvec3 places[]; };
layout(set = 0, binding = 2) readonly buffer F { float f[]; };
layout(set = 0, binding = 3) writeonly buffer G { float g[]; };

// Inserts two zero bits after each bit of x, which is below 1024.
uint spread(uint x) {
    x = (x | (x << 16)) & 0x030000ffu;
    x = (x | (x << 8)) & 0x0300f00fu;
    x = (x | (x << 4)) & 0x030c30c3u;
    return (x | (x << 2)) & 0x09249249u;
}

uint place(uvec3 p) { return spread(p.x) | (spread(p.y) << 1) | (spread(p.z) << 2); }

void main() {
    // More than 65535 workgroups along x are folded into y.
    uint i = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 512u + gl_LocalInvocationID.x;
    if (i >= count) return;
    uint j = i + 256u < count ? i + 256u : i;  // beyond the end, element i again: no branch
    uvec3 p = places[i], q = places[j];
    bool inside = all(lessThan(p, extent)), next_inside = all(lessThan(q, extent));
    // Loads always, from address 0 outside, then selects: no branch.
    float value = f[inside ? place(p) : 0u], next = f[next_inside ? place(q) : 0u];
    g[i] = inside ? value : 0.0;
    g[j] = next_inside ? next : 0.0;
}
