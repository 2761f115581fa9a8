// g = factor * f: the minimal pass whose dispatch runtime_dispatch.cpp times.
#version 460
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
layout(set = 0, binding = 1, scalar) readonly buffer F { float f[]; };
layout(set = 0, binding = 2, scalar) writeonly buffer G { float g[]; };
layout(push_constant, scalar) uniform Parameters { uint size; float factor; };
void main() {
    const uint i = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * gl_WorkGroupSize.x) + gl_GlobalInvocationID.x;
    if (i < size) g[i] = factor * f[i];
}
