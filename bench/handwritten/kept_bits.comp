#version 460
#extension GL_KHR_shader_subgroup_arithmetic : require
// First of a compaction's three passes (then scan_sums.comp, compact.comp): sets a bit for each element that is kept,
// and counts them for each tile. A tile is the elements of one subgroup: `steps` words of 32 bits per lane.

layout(local_size_x = 64) in;

const uint steps = 8;

layout(push_constant) uniform Parameters { uint count; };

layout(set = 0, binding = 1) readonly buffer X { uint x[]; };
layout(set = 0, binding = 1) readonly buffer X4 { uvec4 x4[]; };
layout(set = 0, binding = 2) writeonly buffer Sums { uint sums[]; };
layout(set = 0, binding = 3) writeonly buffer Bits { uint bits[]; };

uint is_kept(uint value) { return uint(value % 8u == 0u); }

void main() {
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint tile = group * gl_NumSubgroups + gl_SubgroupID;
    if (tile * gl_SubgroupSize * steps * 32u >= count) return;
    uint sum = 0u;
    for (uint step = 0u; step < steps; ++step) {
        uint word = (tile * steps + step) * gl_SubgroupSize + gl_SubgroupInvocationID;
        uint kept = 0u;
        if (word * 32u + 32u <= count) {
            for (uint k = 0u; k < 8u; ++k) {
                uvec4 v = x4[word * 8u + k];
                uint four = is_kept(v.x) | (is_kept(v.y) << 1) | (is_kept(v.z) << 2) | (is_kept(v.w) << 3);
                kept |= four << (k * 4u);
            }
        } else {
            for (uint i = word * 32u; i < count; ++i) kept |= is_kept(x[i]) << (i & 31u);
        }
        bits[word] = kept;
        sum += bitCount(kept);
    }
    uint total = subgroupAdd(sum);
    if (subgroupElect()) sums[tile] = total;
}
