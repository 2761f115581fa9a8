#version 460
#extension GL_KHR_shader_subgroup_arithmetic : require
// Second pass of a scan or of a compaction: one workgroup makes the exclusive scan of the tiles' sums, in place, and
// writes their total behind the last one.

layout(local_size_x = 256) in;

const uint steps = 8;   // how many uvec4 an invocation takes in a round

layout(push_constant) uniform Parameters { uint count; };

layout(set = 0, binding = 1) buffer Sums { uint sums[]; };
layout(set = 0, binding = 1) buffer Sums4 { uvec4 sums4[]; };

shared uint totals[gl_WorkGroupSize.x];   // sum of each subgroup, which may have a single lane

void main() {
    uint carry = 0u;
    for (uint base = 0u; base < count; base += gl_WorkGroupSize.x * steps * 4u) {
        uint first = base + gl_LocalInvocationID.x * steps * 4u;
        bool is_full = first + steps * 4u <= count;
        uvec4 v[steps];
        uint sum = 0u;
        if (is_full) {
            for (uint k = 0u; k < steps; ++k) {
                v[k] = sums4[first / 4u + k];
                sum += v[k].x + v[k].y + v[k].z + v[k].w;
            }
        } else {
            for (uint i = first; i < count; ++i) sum += sums[i];
        }
        uint within = subgroupInclusiveAdd(sum);
        barrier();   // until all have read the totals of the round before
        if (gl_SubgroupInvocationID == gl_SubgroupSize - 1u) totals[gl_SubgroupID] = within;
        barrier();
        uint run = carry + within - sum;
        for (uint k = 0u; k < gl_NumSubgroups; ++k) {
            if (k < gl_SubgroupID) run += totals[k];
            carry += totals[k];
        }
        if (is_full) {
            for (uint k = 0u; k < steps; ++k) {
                uint b = run + v[k].x, c = b + v[k].y, d = c + v[k].z;
                sums4[first / 4u + k] = uvec4(run, b, c, d);
                run = d + v[k].w;
            }
        } else {
            for (uint i = first; i < count; ++i) {
                uint value = sums[i];
                sums[i] = run;
                run += value;
            }
        }
    }
    if (gl_LocalInvocationID.x == 0u) sums[count] = carry;
}
