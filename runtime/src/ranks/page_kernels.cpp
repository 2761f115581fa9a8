#include "page_kernels.h"

#include "copy_words.h"
#include "cut_pages.h"
#include "pack_pages.h"
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

void cut_pages_on_host(const HostCall& call) {
    const auto& p = *static_cast<const CutPages*>(call.parameters);
    const std::uint32_t* list = words(call, 0);
    const std::uint32_t* end = list + std::min(words(call, 1)[p.count_word], p.capacity);
    std::uint32_t* begins = words_to_write(call, 2);
    for (std::uint32_t plane = 0; plane < p.planes && p.groups_of_planes != 0; ++plane)
        begins[plane] = words_to_write(call, 3)[plane] =
            static_cast<std::uint32_t>(std::lower_bound(list, end, plane * p.pages_of_plane) - list);
    for (std::uint32_t k = 0; k < p.lists; ++k) {
        const std::uint32_t* bounds = p.bounds + 4 * k;
        std::uint32_t* taken = words_to_write(call, 5 + k);
        std::uint32_t* next = std::copy(list + begins[bounds[0]], list + begins[bounds[1]], taken);
        next = std::copy(list + begins[bounds[2]], list + begins[bounds[3]], next);
        words_to_write(call, 4)[p.first_list + k] = static_cast<std::uint32_t>(next - taken);
    }
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

constexpr std::uint32_t cut_addresses = offsetof(CutPages, addresses);
constexpr Binding cut_bindings[] = {
    {.name = "list", .address_offset = address_of(cut_addresses, 0)},
    {.name = "count", .address_offset = address_of(cut_addresses, 1)},
    {.name = "result", .access = Access::write, .address_offset = address_of(cut_addresses, 2)},
    {.name = "seen", .access = Access::write, .address_offset = address_of(cut_addresses, 3)},
    {.name = "counts", .access = Access::write, .address_offset = address_of(cut_addresses, 4)},
    {.name = "taken_0", .access = Access::write, .address_offset = address_of(cut_addresses, 5)},
    {.name = "taken_1", .access = Access::write, .address_offset = address_of(cut_addresses, 6)},
    {.name = "taken_2", .access = Access::write, .address_offset = address_of(cut_addresses, 7)},
    {.name = "taken_3", .access = Access::write, .address_offset = address_of(cut_addresses, 8)},
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

const Kernel cut_pages_kernel =
    kernel("cut_pages", cut_bindings, 3 * most_rounds,
           {.spirv = cut_pages, .host = cut_pages_on_host, .parameter_bytes = sizeof(CutPages)});
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
