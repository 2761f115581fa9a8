#version 460
// Reads one number and writes one. The one-dimensional arrays are folded row by row into images. An invocation takes
// two elements, a workgroup's width apart.

layout(local_size_x = 256) in;

layout(push_constant) uniform Parameters {
    uint count;
    uint width;
};

layout(set = 0, binding = 1) uniform sampler2D f;
layout(set = 0, binding = 2, r32f) uniform writeonly image2D g;

ivec2 texel_of(uint i) { return ivec2(uvec2(i % width, i / width)); }

void main() {
    // More than 65535 workgroups along x are folded into y.
    uint i = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 512u + gl_LocalInvocationID.x;
    if (i >= count) return;
    uint j = i + 256u < count ? i + 256u : i;  // beyond the end, element i again: no branch
    ivec2 at = texel_of(i), next_at = texel_of(j);
    precise float value = 2.0 * texelFetch(f, at, 0).x + 1.0;  // no fma: the same bits everywhere
    precise float next = 2.0 * texelFetch(f, next_at, 0).x + 1.0;
    imageStore(g, at, vec4(value));
    imageStore(g, next_at, vec4(next));
}
