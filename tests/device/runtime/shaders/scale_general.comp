// g = factor * f, general form: buffers are accessed by address.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_buffer_reference : require
layout(local_size_x = 64) in;
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Floats { float at[]; };
layout(set = 0, binding = 0, scalar) readonly buffer Parameters { uint size; float factor; Floats f; Floats g; };
void main() {
    const uint i = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * gl_WorkGroupSize.x) + gl_GlobalInvocationID.x;
    if (i < size) g.at[i] = factor * f.at[i];
}
