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
    uint groups_of_planes;
    uint lists;
    uint first_list;       // its number
    uint groups_of_list;
    uint unused;
    uint bounds[16];       // planes: of each list, where its lower part begins and ends, then its upper one
    Words list, count, result, seen, counts, taken_0, taken_1, taken_2, taken_3;
};

const uint lanes = 16u;    // that look for one bound
const uint rounds = 8u;    // 17^8 is more than 2^32
shared uint low[4], high[4];

/// Where pages from this one on begin lies between low and high, of each four bounds: sixteen elements are compared at
/// once, so that few loads wait for one another.
void find_bounds(uint k, uint lane, uint pages) {
    if (lane < 4u) low[lane] = 0u;
    if (lane < 4u) high[lane] = pages;
    const uint bound = lane / lanes;
    const uint page = bounds[4u * k + bound] * pages_of_plane;
    for (uint round = 0u; round < rounds; ++round) {
        barrier();
        const uint first = low[bound], end = high[bound];
        const uint at = first + (lane % lanes + 1u) * ((end - first) / (lanes + 1u) + 1u) - 1u;
        barrier();
        if (at >= end) continue;
        if (list.word[at] < page) atomicMax(low[bound], at + 1u);
        else atomicMin(high[bound], at);
    }
    barrier();
}

void main() {
    const uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    const uint lane = gl_LocalInvocationID.x;
    const uint pages = min(count.word[count_word], capacity);
    if (group < groups_of_planes) {
        // Planes begin where a page lies in a later plane than the one before it.
        for (uint i = group * 64u + lane; i <= pages; i += groups_of_planes * 64u) {
            const uint first = i == 0u ? 0u : list.word[i - 1u] / pages_of_plane + 1u;
            const uint last = i == pages ? planes - 1u : list.word[i] / pages_of_plane;
            for (uint plane = first; plane <= last; ++plane) result.word[plane] = seen.word[plane] = i;
        }
        return;
    }
    const uint k = (group - groups_of_planes) / groups_of_list, part = (group - groups_of_planes) % groups_of_list;
    if (k >= lists) return;
    find_bounds(k, lane, pages);
    const uint lower = low[1] - low[0], all = lower + low[3] - low[2];
    Words taken = k == 0u ? taken_0 : k == 1u ? taken_1 : k == 2u ? taken_2 : taken_3;
    for (uint i = part * 64u + lane; i < all; i += groups_of_list * 64u) {
        taken.word[i] = list.word[i < lower ? low[0] + i : low[2] + i - lower];
    }
    if (part == 0u && lane == 0u) counts.word[first_list + k] = all;
}
