// g[i] = g[i] * 2 + amount: repeated over the same memory, the result shows the order of passes.
#version 460
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
layout(set = 0, binding = 1, scalar) buffer G { uint g[]; };
layout(push_constant, scalar) uniform Parameters { uint size; uint amount; };
void main() {
    const uint i = gl_GlobalInvocationID.x;
    if (i < size) g[i] = g[i] * 2u + amount;
}
