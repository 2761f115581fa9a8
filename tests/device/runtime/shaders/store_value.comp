// g[i] = value: a kernel that only writes.
#version 460
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
layout(set = 0, binding = 1, scalar) writeonly buffer G { uint g[]; };
layout(push_constant, scalar) uniform Parameters { uint size; uint value; };
void main() {
    const uint i = gl_GlobalInvocationID.x;
    if (i < size) g[i] = value;
}
