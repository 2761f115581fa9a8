#version 460
// push_even, calls.glift:29: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_memory_scope_semantics : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint x_extent;
    uint bag_capacity;
    uint bag_items_extent;
    bool x_extent_value_0;
};

layout(scalar, set = 0, binding = 1) readonly buffer X_data { uint x_data[]; };
layout(scalar, set = 0, binding = 2) buffer Bag_seen_data { uint bag_seen_data[]; };
layout(scalar, set = 0, binding = 3) coherent buffer Bag_top_data { uint bag_top_data[]; };
layout(scalar, set = 0, binding = 4) writeonly buffer Bag_items_data { uint bag_items_data[]; };
layout(scalar, set = 0, binding = 5) buffer Lost_data { uint lost_data[]; };

// True on lavapipe, where a fence would end the subgroups that do not reach it: then no fence is used.
layout(constant_id = 102) const bool fences_are_barriers = false;
#define load_acquire(place) (fences_are_barriers ? atomicOr(place, 0) : atomicLoad(place, gl_ScopeDevice, gl_StorageSemanticsBuffer, gl_SemanticsAcquire))
#define store_release(place, value) if (fences_are_barriers) atomicExchange(place, value); else atomicStore(place, value, gl_ScopeDevice, gl_StorageSemanticsBuffer, gl_SemanticsRelease)
#define ordered(operation, place, value) (fences_are_barriers ? operation(place, value) : operation(place, value, gl_ScopeDevice, gl_StorageSemanticsBuffer, gl_SemanticsAcquireRelease))

void main() {
    // calls.glift:29
    uint address = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x;
    if (address >= x_extent) return;
    // calls.glift:30
    uint x = x_data[address];
    if (x % 2u == 0u && x < bag_capacity) {
        // calls.glift:31
        uint push = 0u;
        bool push_found = false;
        // calls.glift:13
        uint bag_seen_address = x / 32u;
        if (bag_seen_address < 32u) {
            atomicOr(bag_seen_data[bag_seen_address], 1u << ((x % 32u) & 31u));
        }
        // calls.glift:18
        uint bag_top_before = ordered(atomicAdd, bag_top_data[0u], 1u);
        // calls.glift:31
        if (bag_top_before >= bag_capacity) {
            // calls.glift:20
            push = 0u;
            push_found = false;
        } else {
            // calls.glift:22
            if (bag_top_before < bag_items_extent) {
                bag_items_data[bag_top_before] = x;
            }
            // calls.glift:23
            push = bag_top_before;
            push_found = true;
        }
        // calls.glift:31
        uint found = push;
        bool found_found = push_found;
        uint place = found_found ? found : 4294967295u;
        // calls.glift:32
        if (place == 4294967295u) {
            // calls.glift:33
            if (x_extent_value_0) {
                atomicAdd(lost_data[0u], 1u);
            }
        }
    }
}
