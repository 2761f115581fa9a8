#version 460
// First part of a pass of the radix sort: counts how often each digit occurs in each chunk of keys. Each invocation
// counts one chunk by itself. Counts are stored by digit, within a digit by chunk, so that their exclusive scan is the
// place where each chunk's keys of each digit begin.

layout(local_size_x = 64) in;

const uint digits = 256, steps = 4;

layout(push_constant) uniform Parameters {
    uint count;
    uint chunks;
    uint chunk_size;   // a multiple of 4 * steps
    uint shift;
};

layout(set = 0, binding = 1) readonly buffer X { uint x[]; };
layout(set = 0, binding = 1) readonly buffer X4 { uvec4 x4[]; };
layout(set = 0, binding = 2) writeonly buffer Counts { uint counts[]; };

void main() {
    uint chunk = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
    if (chunk >= chunks) return;
    uint found[digits];
    for (uint digit = 0u; digit < digits; ++digit) found[digit] = 0u;
    uint i = chunk * chunk_size, end = min(i + chunk_size, count);
    for (; i + 4u * steps <= end; i += 4u * steps) {
        uvec4 v[steps];
        for (uint k = 0u; k < steps; ++k) v[k] = (x4[i / 4u + k] >> shift) & (digits - 1u);
        for (uint k = 0u; k < steps; ++k) {
            ++found[v[k].x];
            ++found[v[k].y];
            ++found[v[k].z];
            ++found[v[k].w];
        }
    }
    for (; i < end; ++i) ++found[(x[i] >> shift) & (digits - 1u)];
    for (uint digit = 0u; digit < digits; ++digit) counts[digit * chunks + chunk] = found[digit];
}
