#version 460
// splat, texture_unit.glift:20: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_memory_scope_semantics : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint p_extent;
    uvec2 nearest_extent;
    uint farthest_extent;
    uvec2 marks_extent;
    uint marks_data_extent_x;
};

layout(scalar, set = 0, binding = 1) readonly buffer P_data { vec3 p_data[]; };
layout(set = 0, binding = 2, r32i) uniform iimage2D nearest_data;
layout(scalar, set = 0, binding = 3) buffer Farthest_data { int farthest_data[]; };
layout(set = 0, binding = 4, r32ui) coherent uniform uimage2D marks_data;

// True on lavapipe, where a fence would end the subgroups that do not reach it: then no fence is used.
layout(constant_id = 102) const bool fences_are_barriers = false;
#define texel_load_acquire(image, at) (fences_are_barriers ? imageAtomicOr(image, at, 0) : imageAtomicLoad(image, at, gl_ScopeDevice, gl_StorageSemanticsBuffer | gl_StorageSemanticsImage, gl_SemanticsAcquire))
#define texel_store_release(image, at, value) if (fences_are_barriers) imageAtomicExchange(image, at, value); else imageAtomicStore(image, at, value, gl_ScopeDevice, gl_StorageSemanticsBuffer | gl_StorageSemanticsImage, gl_SemanticsRelease)
#define texel_ordered(operation, image, at, value) (fences_are_barriers ? operation(image, at, value) : operation(image, at, value, gl_ScopeDevice, gl_StorageSemanticsBuffer | gl_StorageSemanticsImage, gl_SemanticsAcquireRelease))
#define texel_compare_exchange(image, at, expected, value) (fences_are_barriers ? imageAtomicCompSwap(image, at, expected, value) : imageAtomicCompSwap(image, at, expected, value, gl_ScopeDevice, gl_StorageSemanticsBuffer | gl_StorageSemanticsImage, gl_SemanticsAcquireRelease, gl_StorageSemanticsBuffer | gl_StorageSemanticsImage, gl_SemanticsAcquire))

// Saturates; not-a-number gives 0.
uint to_uint(float x) {
    float safe = x >= 0.0 && x < 4294967296.0 ? x : 0.0;
    return x >= 4294967296.0 ? 4294967295u : uint(safe);
}

uvec2 to_uint(vec2 a) {
    return uvec2(to_uint(a.x), to_uint(a.y));
}

void nearest_data_min(ivec2 at, float value) {
    const int bits = floatBitsToInt(value);
    if ((bits & 0x7fffffff) > 0x7f800000) return;
    int there = imageLoad(nearest_data, at).x;
    if ((there & 0x7fffffff) > 0x7f800000) there = imageAtomicCompSwap(nearest_data, at, there, bits);
    if (bits >= 0) {
        if (there > bits) imageAtomicMin(nearest_data, at, bits);
        return;
    }
    if (there < 0 && there >= bits) return;
    int before = there < 0 ? there : imageAtomicMin(nearest_data, at, bits);
    if (before < 0) imageAtomicMax(nearest_data, at, max(before, bits));
}

void farthest_data_max(uint index, float value) {
    const int bits = floatBitsToInt(value);
    if ((bits & 0x7fffffff) > 0x7f800000) return;
    int there = farthest_data[index];
    if ((there & 0x7fffffff) > 0x7f800000) there = atomicCompSwap(farthest_data[index], there, bits);
    if (bits >= 0) {
        if (there < bits) atomicMax(farthest_data[index], bits);
        return;
    }
    if (there >= 0 || there <= bits) return;
    int before = atomicMin(farthest_data[index], bits);
    if (before >= 0) atomicMax(farthest_data[index], before);
}

void main() {
    // texture_unit.glift:20
    uint address = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x;
    if (address >= p_extent) return;
    // texture_unit.glift:22
    vec3 p_data_value = p_data[address];
    uvec2 nearest_address = to_uint(p_data_value.xy);
    if (all(lessThan(nearest_address, nearest_extent))) {
        nearest_data_min(ivec2(nearest_address), p_data_value.z);
    }
    // texture_unit.glift:23
    uint farthest_address = to_uint(p_data_value.x);
    if (farthest_address < farthest_extent) {
        farthest_data_max(farthest_address, p_data_value.z);
    }
    // texture_unit.glift:24
    if (all(lessThan(nearest_address, marks_extent))) {
        uint marks_index = nearest_address.y * marks_extent.x + nearest_address.x;
        texel_compare_exchange(marks_data,
            ivec2(uvec2(marks_index % marks_data_extent_x, marks_index / marks_data_extent_x)), 0u, 7u);
    }
}
