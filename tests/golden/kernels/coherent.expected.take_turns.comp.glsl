#version 460
// take_turns, coherent.glift:8: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_memory_scope_semantics : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint a_extent;
    uint state_value_inside;
    bool state_value_inside_2;
};

layout(scalar, set = 0, binding = 1) coherent buffer State_data { uint state_data[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer To_data { uint to_data[]; };

// True on lavapipe, where a fence would end the subgroups that do not reach it: then no fence is used.
layout(constant_id = 102) const bool fences_are_barriers = false;
#define load_acquire(place) (fences_are_barriers ? atomicOr(place, 0) : atomicLoad(place, gl_ScopeDevice, gl_StorageSemanticsBuffer, gl_SemanticsAcquire))
#define store_release(place, value) if (fences_are_barriers) atomicExchange(place, value); else atomicStore(place, value, gl_ScopeDevice, gl_StorageSemanticsBuffer, gl_SemanticsRelease)
#define ordered(operation, place, value) (fences_are_barriers ? operation(place, value) : operation(place, value, gl_ScopeDevice, gl_StorageSemanticsBuffer, gl_SemanticsAcquireRelease))

void main() {
    // coherent.glift:8
    uint address = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x;
    if (address >= a_extent) return;
    // coherent.glift:9
    uint state_value = state_data[state_value_inside];
    uint state_value_1 = state_value_inside_2 ? state_value : 0u;
    // coherent.glift:10
    uint state_address = address + 1u;
    if (state_address < a_extent) {
        state_data[state_address] = state_value_1;
    }
    // coherent.glift:11
    uint state_before = 0u;
    if (state_value_inside_2) {
        state_before = ordered(atomicAdd, state_data[0u], 1u);
    }
    uint state_value_2 = state_data[state_value_inside];
    to_data[address] = state_before + (state_value_inside_2 ? state_value_2 : 0u) - state_value_1;
}
