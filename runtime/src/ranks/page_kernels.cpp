#include "page_kernels.h"

#include "copy_words.h"
#include "find_planes.h"
#include "pack_pages.h"
#include "take_pages.h"
#include "unpack_pages.h"

#include <algorithm>
#include <cstddef>

namespace glift::detail {

namespace {

/// Bound on the rounds of an invocation that takes each 2^18th of 2^32 words.
constexpr std::uint64_t most_rounds = (std::uint64_t{1} << 14) + 1;

const std::uint32_t* words(const HostCall& call, std::size_t memory) {
    return reinterpret_cast<const std::uint32_t*>(call.memories[memory].data);
}
std::uint32_t* words_to_write(const HostCall& call, std::size_t memory) {
    return reinterpret_cast<std::uint32_t*>(call.memories[memory].data);
}

void find_planes_on_host(const HostCall& call) {
    const auto& p = *static_cast<const FindPlanes*>(call.parameters);
    const std::uint32_t* list = words(call, 0);
    const std::uint32_t* end = list + std::min(words(call, 1)[p.count_word], p.capacity);
    for (std::uint32_t plane = 0; plane < p.size; ++plane)
        words_to_write(call, 2)[plane] = words_to_write(call, 3)[plane] =
            static_cast<std::uint32_t>(std::lower_bound(list, end, plane * p.pages_of_plane) - list);
}

void take_pages_on_host(const HostCall& call) {
    const auto& p = *static_cast<const TakePages*>(call.parameters);
    const std::uint32_t *list = words(call, 0), *planes = words(call, 1);
    std::uint32_t* taken = words_to_write(call, 2);
    std::uint32_t* end = std::copy(list + planes[p.lower_first], list + planes[p.lower_end], taken);
    end = std::copy(list + planes[p.upper_first], list + planes[p.upper_end], end);
    words_to_write(call, 3)[p.count_word] = static_cast<std::uint32_t>(end - taken);
}

template <class Copy> void each_run(const HostCall& call, Copy copy) {
    const auto& p = *static_cast<const MovePages*>(call.parameters);
    const std::uint32_t *list = words(call, 0), *table = words(call, 1), *planes = words(call, 2);
    std::size_t at = p.at;
    for (std::uint32_t k = planes[p.first_plane]; k < planes[p.end_plane]; ++k, at += p.run) {
        const std::size_t frame = table[list[k]] - 1;
        copy(frame * (p.frame_bytes / 4) + p.offset, at, p.run);
    }
}

void pack_pages_on_host(const HostCall& call) {
    each_run(call, [&](std::size_t in_frames, std::size_t in_packed, std::uint32_t count) {
        std::copy_n(words(call, 3) + in_frames, count, words_to_write(call, 4) + in_packed);
    });
}

void unpack_pages_on_host(const HostCall& call) {
    each_run(call, [&](std::size_t in_frames, std::size_t in_packed, std::uint32_t count) {
        std::copy_n(words(call, 4) + in_packed, count, words_to_write(call, 3) + in_frames);
    });
}

void copy_words_on_host(const HostCall& call) {
    const auto& p = *static_cast<const CopyWords*>(call.parameters);
    std::copy_n(words(call, 0) + p.from_byte / 4, p.size, words_to_write(call, 1) + p.to_byte / 4);
}

constexpr std::uint32_t address_of(std::size_t first, std::size_t number) {
    return static_cast<std::uint32_t>(first + 8 * number);
}

constexpr std::uint32_t find_addresses = offsetof(FindPlanes, addresses);
constexpr Binding find_bindings[] = {
    {.name = "list", .address_offset = address_of(find_addresses, 0)},
    {.name = "count", .address_offset = address_of(find_addresses, 1)},
    {.name = "result", .access = Access::write, .address_offset = address_of(find_addresses, 2)},
    {.name = "seen", .access = Access::write, .address_offset = address_of(find_addresses, 3)},
};

constexpr std::uint32_t take_addresses = offsetof(TakePages, addresses);
constexpr Binding take_bindings[] = {
    {.name = "list", .address_offset = address_of(take_addresses, 0)},
    {.name = "planes", .address_offset = address_of(take_addresses, 1)},
    {.name = "taken", .access = Access::write, .address_offset = address_of(take_addresses, 2)},
    {.name = "counts", .access = Access::write, .address_offset = address_of(take_addresses, 3)},
};

constexpr std::uint32_t move_addresses = offsetof(MovePages, addresses);
constexpr Binding pack_bindings[] = {
    {.name = "list", .address_offset = address_of(move_addresses, 0)},
    {.name = "table", .address_offset = address_of(move_addresses, 1)},
    {.name = "planes", .address_offset = address_of(move_addresses, 2)},
    {.name = "frames", .address_offset = address_of(move_addresses, 3)},
    {.name = "packed", .access = Access::write, .address_offset = address_of(move_addresses, 4)},
};
constexpr Binding unpack_bindings[] = {
    {.name = "list", .address_offset = address_of(move_addresses, 0)},
    {.name = "table", .address_offset = address_of(move_addresses, 1)},
    {.name = "planes", .address_offset = address_of(move_addresses, 2)},
    {.name = "frames", .access = Access::write, .address_offset = address_of(move_addresses, 3)},
    {.name = "packed", .address_offset = address_of(move_addresses, 4)},
};

constexpr std::uint32_t copy_addresses = offsetof(CopyWords, addresses);
constexpr Binding copy_bindings[] = {
    {.name = "from", .address_offset = address_of(copy_addresses, 0)},
    {.name = "to", .access = Access::write, .address_offset = address_of(copy_addresses, 1)},
};

constexpr Kernel kernel(const char* name, std::span<const Binding> bindings, std::uint64_t rounds, const Form& form) {
    return {.name = name,
            .file = "",
            .line = 0,
            .rank = 1,
            .group = {64, 1, 1},
            .loop_rounds = rounds,
            .bindings = bindings,
            .direct = {},
            .general = form};
}

}  // namespace

const Kernel find_planes_kernel =
    kernel("find_planes", find_bindings, 33,
           {.spirv = find_planes, .host = find_planes_on_host, .parameter_bytes = sizeof(FindPlanes)});
const Kernel take_pages_kernel =
    kernel("take_pages", take_bindings, most_rounds,
           {.spirv = take_pages, .host = take_pages_on_host, .parameter_bytes = sizeof(TakePages)});
const Kernel pack_pages_kernel =
    kernel("pack_pages", pack_bindings, most_rounds,
           {.spirv = pack_pages, .host = pack_pages_on_host, .parameter_bytes = sizeof(MovePages)});
const Kernel unpack_pages_kernel =
    kernel("unpack_pages", unpack_bindings, most_rounds,
           {.spirv = unpack_pages, .host = unpack_pages_on_host, .parameter_bytes = sizeof(MovePages)});
const Kernel copy_words_kernel =
    kernel("copy_words", copy_bindings, 0,
           {.spirv = copy_words, .host = copy_words_on_host, .parameter_bytes = sizeof(CopyWords)});

}  // namespace glift::detail
