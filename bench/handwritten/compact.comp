#version 460
#extension GL_KHR_shader_subgroup_arithmetic : require
#extension GL_KHR_shader_subgroup_ballot : require
// The last of a compaction's three passes: writes the elements whose bits kept_bits.comp set, in order, and their
// number. Elements that are not kept are not read.

layout(local_size_x = 64) in;

const uint steps = 8;

layout(push_constant) uniform Parameters {
    uint count;
    uint tiles;
};

layout(set = 0, binding = 1) readonly buffer X { uint x[]; };
layout(set = 0, binding = 2) readonly buffer Sums { uint sums[]; };
layout(set = 0, binding = 3) readonly buffer Bits { uint bits[]; };
layout(set = 0, binding = 4) writeonly buffer Y { uint y[]; };
layout(set = 0, binding = 5) writeonly buffer Kept { uint kept_in_all; };

void main() {
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint tile = group * gl_NumSubgroups + gl_SubgroupID;
    if (tile >= tiles) return;
    if (tile == 0u) kept_in_all = sums[tiles];
    uint run = sums[tile];
    for (uint step = 0u; step < steps; ++step) {
        uint word = (tile * steps + step) * gl_SubgroupSize + gl_SubgroupInvocationID;
        uint kept = bits[word];
        uint number = bitCount(kept);
        uint within = subgroupInclusiveAdd(number);
        uint at = run + within - number;
        for (; kept != 0u; kept &= kept - 1u) y[at++] = x[word * 32u + findLSB(kept)];
        run += subgroupBroadcast(within, gl_SubgroupSize - 1u);
    }
}
