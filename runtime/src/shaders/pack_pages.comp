// Copies a run of words of each listed page from its frame to a buffer: ranks/page_kernels.h.
#version 460
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;

layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Words { uint word[]; };

layout(set = 0, binding = 0, scalar) readonly buffer Parameters {
    uint size;         // words
    uint first;        // page of the list
    uint run;          // words of a page
    uint offset;       // of the run in a frame
    uint frame_words;
    uint at;           // in the buffer
    Words list, table, frames, packed_words;
};

void main() {
    const uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    const uint i = group * 64u + gl_LocalInvocationID.x;
    if (i >= size) return;
    const uint frame = table.word[list.word[first + i / run]] - 1u;
    const uint from = frame * frame_words + offset + i % run;
    packed_words.word[at + i] = frames.word[from];
}
