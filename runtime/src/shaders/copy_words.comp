// Copies words from one buffer to another one: ranks/page_kernels.h. By a pass, since vkCmdCopyBuffer makes an H200 wait
// for all work before and after.
#version 460
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;

layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Words { uint word[]; };

layout(set = 0, binding = 0, scalar) readonly buffer Parameters {
    uint size;
    uint unused;
    uvec2 from_byte;   // 64 bits, the lower half first
    uvec2 to_byte;
    Words from, to;
};

Words advanced(uvec2 address, uvec2 bytes) {
    uint carry;
    const uint low = uaddCarry(address.x, bytes.x, carry);
    return Words(uvec2(low, address.y + bytes.y + carry));
}

void main() {
    const uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    const uint i = group * 64u + gl_LocalInvocationID.x;
    if (i >= size) return;
    advanced(uvec2(to), to_byte).word[i] = advanced(uvec2(from), from_byte).word[i];
}
