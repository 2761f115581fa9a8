#version 460
#extension GL_EXT_scalar_block_layout : require
// Reads of a 3-D array in Morton order, at places in no order; zero outside.

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint count;
    uvec3 extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer P { uvec3 places[]; };
layout(set = 0, binding = 2) readonly buffer F { float f[]; };
layout(set = 0, binding = 3) writeonly buffer G { float g[]; };

// The bits of x with two zeros between them.
uint spread(uint x) {
    x = (x | (x << 16)) & 0x030000ffu;
    x = (x | (x << 8)) & 0x0300f00fu;
    x = (x | (x << 4)) & 0x030c30c3u;
    return (x | (x << 2)) & 0x09249249u;
}

void main() {
    // More than 65535 workgroups along x are folded into y.
    uint i = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x;
    if (i >= count) return;
    uvec3 p = places[i];
    bool inside = all(lessThan(p, extent));
    // Always a load, never a branch.
    float value = f[inside ? spread(p.x) | (spread(p.y) << 1) | (spread(p.z) << 2) : 0u];
    g[i] = inside ? value : 0.0;
}
