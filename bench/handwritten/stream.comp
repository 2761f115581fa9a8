#version 460
// A stream of numbers, folded row by row into an image.

layout(local_size_x = 256) in;

layout(push_constant) uniform Parameters {
    uint count;
    uint width;
};

layout(set = 0, binding = 1) uniform sampler2D f;
layout(set = 0, binding = 2, r32f) uniform writeonly image2D g;

void main() {
    // More than 65535 workgroups along x are folded into y.
    uint i = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x;
    if (i >= count) return;
    ivec2 texel = ivec2(uvec2(i % width, i / width));
    precise float value = 2.0 * texelFetch(f, texel, 0).x + 1.0;   // no contraction: the same bits everywhere
    imageStore(g, texel, vec4(value));
}
