// Fills words of a buffer, one per invocation: used for up to 1 MiB, and under conditions. vkCmdFillBuffer makes an
// H200 wait for all work before and after, which takes 5 us even for four bytes.
#version 460
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(buffer_reference, scalar, buffer_reference_align = 4) writeonly buffer Words { uint word[]; };

layout(push_constant, scalar) uniform Push {
    Words to;
    uint count;
    uint value;
};

void main() {
    if (gl_GlobalInvocationID.x < count) to.word[gl_GlobalInvocationID.x] = value;
}
