// g = the number of the lane in its subgroup.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_basic : require
layout(local_size_x = 64) in;
layout(set = 0, binding = 1, scalar) writeonly buffer G { uint g[]; };
layout(push_constant, scalar) uniform Parameters { uint size; uint unused; };
void main() {
    const uint i = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * gl_WorkGroupSize.x) + gl_GlobalInvocationID.x;
    if (i < size) g[i] = gl_SubgroupInvocationID;
}
