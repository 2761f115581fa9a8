#version 460
// use_both, operators.glift:35: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_basic : require

layout(local_size_x = 256) in;

struct Affine {
    uint modulus;
};

layout(push_constant, scalar) uniform Parameters {
    uint a_extent;
    uint affine_modulus;
};

layout(scalar, set = 0, binding = 1) buffer A_data { uint a_data[]; };

layout(scalar, set = 0, binding = 2) buffer Status {
    uint code, line, rank, memory, address[4], file;
} status;

// After this many iterations in all, the device ends the loops of an invocation; 0: never.
layout(constant_id = 101) const uint loop_round_limit = 0u;
shared uint loop_rounds[loop_round_limit == 0u ? 1u : 64u];

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

// operators.glift:15
uint combine(uint a, uint b) {
    return max(a, b);
}

// repeated<Max>
// operators.glift:25
uint repeated(uint a, uint limit) {
    // operators.glift:26
    uint x = 1u;
    // operators.glift:27
    uint rounds = 0u;
    // operators.glift:28
    while (another_round(0u, 28u) && rounds < limit) {
        // operators.glift:29
        x = combine(x, a);
        // operators.glift:30
        rounds += 1u;
    }
    // operators.glift:32
    return x;
}

// operators.glift:22
uint combine_1(Affine op, uint a, uint b) {
    return combine(a * b + a, b) % max(op.modulus, 1u);
}

// repeated<Affine>
// operators.glift:25
uint repeated_Affine(Affine op, uint a, uint limit) {
    // operators.glift:26
    uint x = 1u;
    // operators.glift:27
    uint rounds = 0u;
    // operators.glift:28
    while (another_round(0u, 28u) && rounds < limit) {
        // operators.glift:29
        x = combine_1(op, x, a);
        // operators.glift:30
        rounds += 1u;
    }
    // operators.glift:32
    return x;
}

void main() {
    if (loop_round_limit != 0u) loop_rounds[gl_SubgroupID] = 2u;
    // operators.glift:35
    uint address = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x;
    if (address >= a_extent) return;
    // operators.glift:36
    uint a_value = a_data[address];
    a_data[address] = repeated(a_value, 4u) + repeated_Affine(Affine(affine_modulus), a_value, 5u);
}
