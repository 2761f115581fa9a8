// Copies two parts of a list of pages to a list of their own: ranks/page_kernels.h.
#version 460
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;

layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Words { uint word[]; };

layout(set = 0, binding = 0, scalar) readonly buffer Parameters {
    uint size;
    uint lower;        // where the first part begins in the list
    uint lower_count;
    uint upper;        // where the second part begins
    Words list, taken;
};

void main() {
    const uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    const uint i = group * 64u + gl_LocalInvocationID.x;
    if (i >= size) return;
    taken.word[i] = list.word[i < lower_count ? lower + i : upper + i - lower_count];
}
