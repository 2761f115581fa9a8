#version 460
// block_sums, group.glift:8: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_basic : require

layout(local_size_x = 64) in;

layout(push_constant, scalar) uniform Parameters {
    uint value_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer Value_data { uint value_data[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer Sums_data { uint sums_data[]; };

shared uint part[64];

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

void main() {
    if (loop_round_limit != 0u) loop_rounds[gl_SubgroupID] = 0u;
    // group.glift:8
    uint address = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 64u) + gl_GlobalInvocationID.x;
    bool in_range = address < value_extent;
    // group.glift:10
    uint i = gl_LocalInvocationIndex;
    // group.glift:11
    uint value_value = 0u;
    if (in_range) {
        value_value = value_data[address];
    }
    part[i] = value_value;
    // group.glift:12
    barrier();
    // group.glift:13
    uint step_1 = 32u;
    // group.glift:14
    while (another_round(0u, 14u) && step_1 > 0u) {
        // group.glift:15
        if (i < step_1) {
            part[i] += part[min(i + step_1, 63u)];
        }
        // group.glift:16
        barrier();
        // group.glift:17
        step_1 /= 2u;
    }
    // group.glift:19
    if (i == 0u) {
        uint sums_address = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
        if (sums_address < value_extent) {
            sums_data[sums_address] = part[0u];
        }
    }
}
