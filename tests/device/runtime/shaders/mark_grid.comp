// Counts visits of each element of a three-dimensional range; base is the first workgroup of this dispatch.
#version 460
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 1) in;
layout(set = 0, binding = 0, scalar) readonly buffer Parameters { uint size[3]; uint base[3]; };
layout(set = 0, binding = 1, scalar) buffer G { uint g[]; };
void main() {
    const uvec3 at = (gl_WorkGroupID + uvec3(base[0], base[1], base[2])) * gl_WorkGroupSize + gl_LocalInvocationID;
    if (at.x >= size[0] || at.y >= size[1] || at.z >= size[2]) return;
    atomicAdd(g[(at.z * size[1] + at.y) * size[0] + at.x], 1u + at.y);
}
