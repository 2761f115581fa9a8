// Copies the pages of two parts of the planes to a list of their own, and counts them: ranks/page_kernels.h.
#version 460
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;

layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Words { uint word[]; };

layout(set = 0, binding = 0, scalar) readonly buffer Parameters {
    uint size;         // invocations
    uint lower_first;  // planes
    uint lower_end;
    uint upper_first;
    uint upper_end;
    uint count_word;   // in `counts`
    Words list, planes, taken, counts;
};

void main() {
    const uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    const uint lower = planes.word[lower_first], upper = planes.word[upper_first];
    const uint lower_count = planes.word[lower_end] - lower;
    const uint count = lower_count + planes.word[upper_end] - upper;
    for (uint i = group * 64u + gl_LocalInvocationID.x; i < count; i += size) {
        taken.word[i] = list.word[i < lower_count ? lower + i : upper + i - lower_count];
    }
    if (group == 0u && gl_LocalInvocationID.x == 0u) counts.word[count_word] = count;
}
