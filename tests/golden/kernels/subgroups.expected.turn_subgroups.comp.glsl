#version 460
// turn_subgroups, subgroups.glift:36: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_memory_scope_semantics : require
#extension GL_KHR_shader_subgroup_basic : require

layout(local_size_x = 64) in;

layout(push_constant, scalar) uniform Parameters {
    uint from_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer From_data { uint from_data[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer To_data { uint to_data[]; };

shared uint values[64];

// True on lavapipe, where a fence would end the subgroups that do not reach it: then no fence is used.
layout(constant_id = 102) const bool fences_are_barriers = false;

void main() {
    // subgroups.glift:36
    uint address = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 64u) + gl_GlobalInvocationID.x;
    bool in_range = address < from_extent;
    // subgroups.glift:38
    uint from_value = 0u;
    if (in_range) {
        from_value = from_data[address];
    }
    values[gl_LocalInvocationIndex] = from_value;
    // subgroups.glift:39
    if (!fences_are_barriers) controlBarrier(gl_ScopeSubgroup, gl_ScopeSubgroup, gl_StorageSemanticsShared,
        gl_SemanticsAcquireRelease);
    // subgroups.glift:40
    if (in_range) {
        to_data[address] = values[min(gl_LocalInvocationIndex + gl_SubgroupSize - 1u - 2u
            * gl_SubgroupInvocationID, 63u)];
    }
}
