#version 460
#extension GL_KHR_shader_subgroup_arithmetic : require
#extension GL_KHR_shader_subgroup_ballot : require
// Last of a scan's three passes: the exclusive scan of each tile's elements (tiles as in tile_sums.comp), beginning
// with the sum of all tiles before. No shared memory and no barrier: subgroups need nothing from each other.

layout(local_size_x = 64) in;

const uint steps = 16;

layout(push_constant) uniform Parameters { uint count; };

layout(set = 0, binding = 1) readonly buffer X { uint x[]; };
layout(set = 0, binding = 1) readonly buffer X4 { uvec4 x4[]; };
layout(set = 0, binding = 2) readonly buffer Sums { uint sums[]; };
layout(set = 0, binding = 3) writeonly buffer Y { uint y[]; };
layout(set = 0, binding = 3) writeonly buffer Y4 { uvec4 y4[]; };

void main() {
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint tile = group * gl_NumSubgroups + gl_SubgroupID;
    uint size = gl_SubgroupSize * steps * 4u, first = tile * size, last = gl_SubgroupSize - 1u;
    if (first >= count) return;
    uint run = sums[tile];
    if (count - first >= size) {
        for (uint k = 0u; k < steps; ++k) {
            uint i = first / 4u + k * gl_SubgroupSize + gl_SubgroupInvocationID;
            uvec4 v = x4[i];
            uint sum = v.x + v.y + v.z + v.w;
            uint within = subgroupInclusiveAdd(sum);
            uint a = run + within - sum, b = a + v.x, c = b + v.y;
            y4[i] = uvec4(a, b, c, c + v.z);
            run += subgroupBroadcast(within, last);
        }
    } else {
        for (uint base = first; base < count; base += gl_SubgroupSize) {
            uint i = base + gl_SubgroupInvocationID;
            uint value = i < count ? x[i] : 0u;
            uint within = subgroupInclusiveAdd(value);
            if (i < count) y[i] = run + within - value;
            run += subgroupBroadcast(within, last);
        }
    }
}
