#version 460
// Random reads of a 1-D array folded into the rows of an image; zero outside. An invocation takes two elements.

layout(local_size_x = 256) in;

layout(push_constant) uniform Parameters {
    uint count;
    uint size;
    uint width;
};

layout(set = 0, binding = 1) readonly buffer P { uint places[]; };
layout(set = 0, binding = 2) uniform sampler2D f;
layout(set = 0, binding = 3) writeonly buffer G { float g[]; };

void main() {
    uint i = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 512u + gl_LocalInvocationID.x;
    if (i >= count) return;
    uint j = i + 256u < count ? i + 256u : i;
    uint p = places[i], q = places[j];
    // Fetches outside of the image are undefined: fetches texel 0 there, then selects zero.
    uint at = p < size ? p : 0u, next_at = q < size ? q : 0u;
    float value = texelFetch(f, ivec2(at % width, at / width), 0).x;
    float next = texelFetch(f, ivec2(next_at % width, next_at / width), 0).x;
    g[i] = p < size ? value : 0.0;
    g[j] = q < size ? next : 0.0;
}
