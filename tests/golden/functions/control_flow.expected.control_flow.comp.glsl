#version 460
// control_flow, control_flow.glift:40: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_basic : require

layout(local_size_x = 256) in;

struct Interval {
    float low;
    float high;
};

layout(push_constant, scalar) uniform Parameters {
    uint a_extent;
    bool mode_value_0;
};

layout(scalar, set = 0, binding = 1) writeonly buffer F_data { float f_data[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer N_data { uint n_data[]; };

layout(scalar, set = 0, binding = 3) buffer Status {
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

// By the sign bit: drivers may drop the sign of zero of -x if x is a choice between 0.0 and 1.0.
float negative(float x) {
    return uintBitsToFloat(floatBitsToUint(x) ^ 0x80000000u);
}

// By the sign bit: drivers may take x for positive if it is a choice that -0.0 is in.
float magnitude(float x) {
    return uintBitsToFloat(floatBitsToUint(x) & 0x7fffffffu);
}

// halves<3>
// control_flow.glift:18
float halves(float x) {
    // control_flow.glift:19
    float y = x;
    // control_flow.glift:20
    for (uint i = 0u; another_round(0u, 20u) && i < 3u; ++i) {
        y *= 0.5;
    }
    // control_flow.glift:21
    return y;
}

// control_flow.glift:29
uint collatz(uint start) {
    // control_flow.glift:30
    uint n = start;
    // control_flow.glift:31
    uint steps = 0u;
    // control_flow.glift:32
    while (another_round(0u, 32u) && n > 1u) {
        // control_flow.glift:33
        if (steps == 100u) {
            break;
        }
        // control_flow.glift:34
        if (n % 2u == 0u) {
            n /= 2u;
        } else {
            n = 3u * n + 1u;
        }
        // control_flow.glift:35
        steps += 1u;
    }
    // control_flow.glift:37
    return steps;
}

void main() {
    if (loop_round_limit != 0u) loop_rounds[gl_SubgroupID] = 2u;
    // control_flow.glift:40
    uint address = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x;
    if (address >= a_extent) return;
    // control_flow.glift:41
    Interval i = Interval(1.0, float(address));
    // control_flow.glift:42
    float x = i.high - i.low + halves(i.high);
    // control_flow.glift:43
    uint found = address / 2u;
    bool found_found = !(address % 2u == 0u);
    if (found_found) {
        x += float(found);
    } else {
        x = negative(x);
    }
    // control_flow.glift:44
    f_data[address] = mode_value_0 ? x : sqrt(magnitude(x));
    // control_flow.glift:45
    n_data[address] = collatz(address) + (found_found ? found : 7u);
}
