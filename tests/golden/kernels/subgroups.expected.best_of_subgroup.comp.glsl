#version 460
// best_of_subgroup, subgroups.glift:22: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_shuffle : require

layout(local_size_x = 64) in;

struct Best {
    float value;
    uvec2 where;
    int list[2];
};

layout(push_constant, scalar) uniform Parameters {
    uint from_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer From_data { uint from_data[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer To_data { uint to_data[]; };

layout(scalar, set = 0, binding = 3) buffer Status {
    uint code, line, rank, memory, address[4], file;
} status;

// After this many iterations in all, the device ends the loops of an invocation; 0: never.
layout(constant_id = 101) const uint loop_round_limit = 0u;
shared uint loop_rounds[loop_round_limit == 0u ? 1u : 16u];

// Counts an iteration of a loop. False where the limit is reached; the first loop that reaches it is reported.
// A subgroup has one count: devices with a limit run its lanes in lockstep.
// `idle_rounds`: iterations of loops inside the caller's that may run with no lane active: they count.
bool another_round(uint idle_rounds, uint line) {
    if (loop_round_limit == 0u) return true;
    uint rounds = loop_rounds[gl_SubgroupID] + 1u + idle_rounds;
    loop_rounds[gl_SubgroupID] = rounds;
    if (rounds < loop_round_limit) return true;
    if (atomicCompSwap(status.code, 0u, 1u) == 0u) status.line = line;
    return false;
}

float shuffled_xor(float value, uint mask) {
    float other = subgroupShuffleXor(value, mask);
    return (gl_SubgroupInvocationID ^ mask) < gl_SubgroupSize ? other : value;
}

uvec2 shuffled_xor(uvec2 value, uint mask) {
    uvec2 other = subgroupShuffleXor(value, mask);
    return (gl_SubgroupInvocationID ^ mask) < gl_SubgroupSize ? other : value;
}

int shuffled_xor(int value, uint mask) {
    int other = subgroupShuffleXor(value, mask);
    return (gl_SubgroupInvocationID ^ mask) < gl_SubgroupSize ? other : value;
}

int[2] shuffled_xor(int value[2], uint mask) {
    for (int i = 0; i < 2; ++i) value[i] = shuffled_xor(value[i], mask);
    return value;
}

Best shuffled_xor(Best value, uint mask) {
    value.value = shuffled_xor(value.value, mask);
    value.where = shuffled_xor(value.where, mask);
    value.list = shuffled_xor(value.list, mask);
    return value;
}

uvec2 broadcast(uvec2 value, uint lane) {
    uvec2 other = subgroupBroadcast(value, lane);
    return lane < gl_SubgroupSize ? other : value;
}

uint shuffled(uint value, uint lane) {
    uint other = subgroupShuffle(value, lane);
    return lane < gl_SubgroupSize ? other : value;
}

// subgroups.glift:15
Best better(Best a, Best b) {
    // subgroups.glift:16
    if (b.value < a.value) {
        // subgroups.glift:17
        return b;
    }
    // subgroups.glift:19
    return a;
}

void main() {
    if (loop_round_limit != 0u) loop_rounds[gl_SubgroupID] = 0u;
    // subgroups.glift:22
    uint address = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 64u) + gl_GlobalInvocationID.x;
    bool in_range = address < from_extent;
    // subgroups.glift:23
    uint lane = gl_SubgroupInvocationID;
    // subgroups.glift:24
    uint from_value = 0u;
    if (in_range) {
        from_value = from_data[address];
    }
    Best best = Best(float(from_value), uvec2(lane, gl_SubgroupID), int[2](1, 2));
    // subgroups.glift:25
    uint stride = gl_SubgroupSize / 2u;
    // subgroups.glift:26
    while (another_round(0u, 26u) && stride > 0u) {
        // subgroups.glift:27
        best = better(best, shuffled_xor(best, stride));
        // subgroups.glift:28
        stride /= 2u;
    }
    // subgroups.glift:30
    uvec2 first = broadcast(best.where, 0u);
    // subgroups.glift:31
    uvec4 mask = subgroupBallot(lane == first.x);
    // subgroups.glift:32
    if (in_range) {
        to_data[address] = first.x + mask.x + gl_NumSubgroups + shuffled(from_value, lane + 1u);
    }
}
