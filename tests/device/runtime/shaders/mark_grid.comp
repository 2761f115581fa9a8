// Adds 1 + y to each visited element of a 3-D grid; `base` is the first element of this dispatch where a grid is split.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_buffer_reference : require
layout(local_size_x = 1) in;
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Counts { uint at[]; };
layout(set = 0, binding = 0, scalar) readonly buffer Parameters { uint size[3]; uint base[3]; Counts g; };
void main() {
    const uvec3 at = gl_GlobalInvocationID + uvec3(base[0], base[1], base[2]);
    if (at.x >= size[0] || at.y >= size[1] || at.z >= size[2]) return;
    atomicAdd(g.at[(at.z * size[1] + at.y) * size[0] + at.x], 1u + at.y);
}
