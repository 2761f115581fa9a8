// Writes the first ten elements; reports an access out of range if there is an element 10.
#version 460
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
layout(set = 0, binding = 1, scalar) buffer G { uint g[]; };
layout(set = 0, binding = 2, scalar) buffer Status { uint code; uint line; uint rank; uint where; uint address[4]; };
layout(push_constant, scalar) uniform Parameters { uint size; };
void main() {
    const uint i = gl_GlobalInvocationID.x;
    if (i >= size) return;
    if (i < 10u) {
        g[i] = i;
    } else if (i == 10u && atomicCompSwap(code, 0u, 2u) == 0u) {
        line = 21u;
        rank = 1u;
        where = 0u;
        address[0] = i;
    }
}
