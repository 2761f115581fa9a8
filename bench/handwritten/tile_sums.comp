#version 460
#extension GL_KHR_shader_subgroup_arithmetic : require
// First of the three passes of a scan (then scan_sums.comp, scan.comp): the sum of each tile. A tile is the elements of
// one subgroup: `steps` uvec4 per lane; in each step neighbouring lanes read neighbouring uvec4.

layout(local_size_x = 64) in;

const uint steps = 16;

layout(push_constant) uniform Parameters { uint count; };

layout(set = 0, binding = 1) readonly buffer X { uint x[]; };
layout(set = 0, binding = 1) readonly buffer X4 { uvec4 x4[]; };
layout(set = 0, binding = 2) writeonly buffer Sums { uint sums[]; };

void main() {
    // More than 65535 workgroups along x are folded into y.
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint tile = group * gl_NumSubgroups + gl_SubgroupID;
    uint size = gl_SubgroupSize * steps * 4u, first = tile * size;
    if (first >= count) return;
    uint sum = 0u;
    if (count - first >= size) {
        uvec4 sum4 = uvec4(0u);
        for (uint k = 0u; k < steps; ++k) sum4 += x4[first / 4u + k * gl_SubgroupSize + gl_SubgroupInvocationID];
        sum = sum4.x + sum4.y + sum4.z + sum4.w;
    } else {
        for (uint i = first + gl_SubgroupInvocationID; i < count; i += gl_SubgroupSize) sum += x[i];
    }
    uint total = subgroupAdd(sum);
    if (subgroupElect()) sums[tile] = total;
}
