// Kernels of the runtime that find and move pages of sparse structures.
#pragma once

#include <glift/kernel.h>

namespace glift::detail {

/// Bindings: list, count, result. result[k] is the index in the ascending list at which pages from k * pages_of_plane
/// on begin.
struct FindPlanes {
    std::uint32_t size, pages_of_plane, count_word, capacity;
    std::uint64_t addresses[3];
};
extern const Kernel find_planes_kernel;

/// Bindings: list, table, frames, packed. Copies words [offset, offset + run) of the frames of the listed pages from
/// `first` on, one page after the other, to the words of `packed` from `at` on; unpack_pages copies them back. `size`
/// is the number of words.
struct MovePages {
    std::uint32_t size, first, run, offset, frame_words, at;
    std::uint64_t addresses[4];
};
extern const Kernel pack_pages_kernel, unpack_pages_kernel;

/// Bindings: list, taken. Copies `lower_count` words of the list from `lower` on, then those from `upper` on, `size` in
/// total. By a pass, since vkCmdCopyBuffer makes an H200 wait for all work before and after.
struct TakePages {
    std::uint32_t size, lower, lower_count, upper;
    std::uint64_t addresses[2];
};
extern const Kernel take_pages_kernel;

}  // namespace glift::detail
