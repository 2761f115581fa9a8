// Kernels of the runtime that find and move pages of sparse structures, and planes of dense ones.
#pragma once

#include <glift/kernel.h>

namespace glift::detail {

/// Bindings: list, count, result, seen, counts, taken (four). result[k], and seen[k], is the index in the ascending
/// list at which pages from k * pages_of_plane on begin, but where groups_of_planes is 0. Copies, to each of `lists`
/// lists, the pages of the planes [bounds[0], bounds[1]), then those of [bounds[2], bounds[3]), and writes their number
/// to counts[first_list], counts[first_list + 1], ... `size` is the number of invocations: 64 * groups_of_planes, and
/// 64 * groups_of_list for each list.
struct CutPages {
    static constexpr std::uint32_t most_lists = 4;

    std::uint32_t size, planes, pages_of_plane, count_word, capacity, groups_of_planes, lists, first_list,
        groups_of_list, unused;
    std::uint32_t bounds[4 * most_lists];
    std::uint64_t addresses[5 + most_lists];
};
extern const Kernel cut_pages_kernel;

/// Bindings: list, table, planes, frames, packed. Copies words [offset, offset + run) of the frames of the pages of
/// planes [first_plane, end_plane), one page after the other, to the words of `packed` from `at` on; unpack_pages
/// copies them back. `planes` is the result of cut_pages, `size` the number of invocations.
struct MovePages {
    std::uint32_t size, first_plane, end_plane, run, offset, frame_bytes, at, unused;
    std::uint64_t addresses[5];
};
extern const Kernel pack_pages_kernel, unpack_pages_kernel;

/// Bindings: from, to. Copies `size` words. By a pass, since vkCmdCopyBuffer makes an H200 wait for all work before and
/// after.
struct CopyWords {
    std::uint32_t size, unused;
    std::uint64_t from_byte, to_byte;
    std::uint64_t addresses[2];
};
extern const Kernel copy_words_kernel;

}  // namespace glift::detail
