#version 460
// Last part of a pass of the radix sort: moves the keys to the places that the scan of digit_counts.comp's counts
// gives. Each invocation moves one chunk in sequence, so that the sort is stable.

layout(local_size_x = 64) in;

const uint digits = 256, steps = 4;

layout(push_constant) uniform Parameters {
    uint count;
    uint chunks;
    uint chunk_size;
    uint shift;
};

layout(set = 0, binding = 1) readonly buffer X { uint x[]; };
layout(set = 0, binding = 1) readonly buffer X4 { uvec4 x4[]; };
layout(set = 0, binding = 2) readonly buffer Offsets { uint offsets[]; };
layout(set = 0, binding = 3) writeonly buffer Y { uint y[]; };

uint next[digits];

void put(uint key) {
    uint digit = (key >> shift) & (digits - 1u);
    uint at = next[digit];
    next[digit] = at + 1u;
    y[at] = key;
}

void main() {
    uint chunk = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
    if (chunk >= chunks) return;
    for (uint digit = 0u; digit < digits; ++digit) next[digit] = offsets[digit * chunks + chunk];
    uint i = chunk * chunk_size, end = min(i + chunk_size, count);
    for (; i + 4u * steps <= end; i += 4u * steps) {
        uvec4 v[steps];
        for (uint k = 0u; k < steps; ++k) v[k] = x4[i / 4u + k];
        for (uint k = 0u; k < steps; ++k) {
            put(v[k].x);
            put(v[k].y);
            put(v[k].z);
            put(v[k].w);
        }
    }
    for (; i < end; ++i) put(x[i]);
}
