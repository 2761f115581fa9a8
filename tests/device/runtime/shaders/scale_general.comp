// g = factor * f, general form: parameters are in a buffer.
#version 460
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
layout(set = 0, binding = 0, scalar) readonly buffer Parameters { uint size; float factor; };
layout(set = 0, binding = 1, scalar) readonly buffer F { float f[]; };
layout(set = 0, binding = 2, scalar) writeonly buffer G { float g[]; };
void main() {
    const uint i = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * gl_WorkGroupSize.x) + gl_GlobalInvocationID.x;
    if (i < size) g[i] = factor * f[i];
}
