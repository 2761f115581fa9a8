// Kernels of the runtime that find and move pages of sparse structures, and planes of dense ones.
#pragma once

#include <glift/kernel.h>

namespace glift::detail {

/// Bindings: list, count, result, seen. result[k], and seen[k], is the index in the ascending list at which pages from
/// k * pages_of_plane on begin.
struct FindPlanes {
    std::uint32_t size, pages_of_plane, count_word, capacity;
    std::uint64_t addresses[4];
};
extern const Kernel find_planes_kernel;

/// Bindings: list, planes, taken, counts. Copies the pages of the planes [lower_first, lower_end), then those of
/// [upper_first, upper_end), from the list to `taken`, and writes their number to a word of `counts`. `planes` is the
/// result of find_planes, `size` the number of invocations.
struct TakePages {
    std::uint32_t size, lower_first, lower_end, upper_first, upper_end, count_word;
    std::uint64_t addresses[4];
};
extern const Kernel take_pages_kernel;

/// Bindings: list, table, planes, frames, packed. Copies words [offset, offset + run) of the frames of the pages of
/// planes [first_plane, end_plane), one page after the other, to the words of `packed` from `at` on; unpack_pages
/// copies them back. `size` is the number of invocations.
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
