// Copies a run of words of each page of some planes between its frame and a buffer, into which it goes if PACKS is
// defined: ranks/page_kernels.h.
#version 460
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;

layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Words { uint word[]; };

layout(set = 0, binding = 0, scalar) readonly buffer Parameters {
    uint size;         // invocations
    uint first_plane;
    uint end_plane;
    uint run;          // words of a page
    uint offset;       // of the run in a frame
    uint frame_bytes;
    uint at;           // in the buffer
    uint unused;
    Words list, table, planes, frames, packed_words;
};

/// The run of a page, whose frame may begin beyond 4 GiB.
Words frame_words_of(uint page) {
    uint high, low, carry;
    umulExtended(table.word[page] - 1u, frame_bytes, high, low);
    const uvec2 address = uvec2(frames);
    const uint sum = uaddCarry(address.x, low, carry);
    high += address.y + carry;
    const uint begin = uaddCarry(sum, 4u * offset, carry);
    return Words(uvec2(begin, high + carry));
}

void main() {
    const uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    const uint first = planes.word[first_plane];
    const uint words = (planes.word[end_plane] - first) * run;
    for (uint i = group * 64u + gl_LocalInvocationID.x; i < words; i += size) {
        const uint page = list.word[first + i / run];
#ifdef PACKS
        packed_words.word[at + i] = frame_words_of(page).word[i % run];
#else
        frame_words_of(page).word[i % run] = packed_words.word[at + i];
#endif
    }
}
