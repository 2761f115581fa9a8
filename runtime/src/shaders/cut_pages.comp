// Finds where each plane of pages begins in an ascending list of pages, and copies parts of that list to lists of their
// own: ranks/page_kernels.h. In one pass, since each pass takes some microseconds: the workgroups of a list look for its
// parts themselves.
#version 460
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;

layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Words { uint word[]; };

layout(set = 0, binding = 0, scalar) readonly buffer Parameters {
    uint size;
    uint planes;           // and one: the end of the last one
    uint pages_of_plane;
    uint count_word;
    uint capacity;
    uint lists;
    uint first_list;       // its number
    uint groups_of_list;
    uint bounds[16];       // planes: of each list, where its lower part begins and ends, then its upper one
    Words list, count, result, seen, counts, taken_0, taken_1, taken_2, taken_3;
};

shared uint at[4];

/// How many pages of the list come before this plane.
uint begin_of(uint plane) {
    uint low = 0u, high = min(count.word[count_word], capacity);
    const uint page = plane * pages_of_plane;
    while (low < high) {
        const uint middle = (low + high) / 2u;
        if (list.word[middle] < page) low = middle + 1u;
        else high = middle;
    }
    return low;
}

void main() {
    const uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    const uint lane = gl_LocalInvocationID.x;
    const uint groups_of_planes = (planes + 63u) / 64u;
    if (group < groups_of_planes) {
        const uint plane = group * 64u + lane;
        if (plane < planes) result.word[plane] = seen.word[plane] = begin_of(plane);
        return;
    }
    const uint k = (group - groups_of_planes) / groups_of_list, part = (group - groups_of_planes) % groups_of_list;
    if (k >= lists) return;
    if (lane < 4u) at[lane] = begin_of(bounds[4u * k + lane]);
    barrier();
    const uint lower = at[1] - at[0], all = lower + at[3] - at[2];
    Words taken = k == 0u ? taken_0 : k == 1u ? taken_1 : k == 2u ? taken_2 : taken_3;
    for (uint i = part * 64u + lane; i < all; i += groups_of_list * 64u) {
        taken.word[i] = list.word[i < lower ? at[0] + i : at[2] + i - lower];
    }
    if (part == 0u && lane == 0u) counts.word[first_list + k] = all;
}
