#include "page_kernels.h"

#include "find_planes.h"
#include "pack_pages.h"
#include "take_pages.h"
#include "unpack_pages.h"

#include <algorithm>
#include <cstddef>

namespace glift::detail {

namespace {

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
    std::uint32_t* result = words_to_write(call, 2);
    for (std::uint32_t plane = 0; plane < p.size; ++plane)
        result[plane] = static_cast<std::uint32_t>(std::lower_bound(list, end, plane * p.pages_of_plane) - list);
}

template <class Copy> void each_run(const HostCall& call, Copy copy) {
    const auto& p = *static_cast<const MovePages*>(call.parameters);
    const std::uint32_t *list = words(call, 0), *table = words(call, 1);
    for (std::uint32_t k = 0; k * p.run < p.size; ++k) {
        const std::size_t frame = table[list[p.first + k]] - 1;
        copy(frame * p.frame_words + p.offset, p.at + std::size_t{k} * p.run, p.run);
    }
}

void pack_pages_on_host(const HostCall& call) {
    each_run(call, [&](std::size_t in_frames, std::size_t in_packed, std::uint32_t count) {
        std::copy_n(words(call, 2) + in_frames, count, words_to_write(call, 3) + in_packed);
    });
}

void unpack_pages_on_host(const HostCall& call) {
    each_run(call, [&](std::size_t in_frames, std::size_t in_packed, std::uint32_t count) {
        std::copy_n(words(call, 3) + in_packed, count, words_to_write(call, 2) + in_frames);
    });
}

void take_pages_on_host(const HostCall& call) {
    const auto& p = *static_cast<const TakePages*>(call.parameters);
    std::uint32_t* taken = words_to_write(call, 1);
    std::copy_n(words(call, 0) + p.lower, p.lower_count, taken);
    std::copy_n(words(call, 0) + p.upper, p.size - p.lower_count, taken + p.lower_count);
}

constexpr std::uint32_t address_of(std::size_t first, std::size_t number) {
    return static_cast<std::uint32_t>(first + 8 * number);
}

constexpr Binding find_planes_bindings[] = {
    {.name = "list", .address_offset = address_of(offsetof(FindPlanes, addresses), 0)},
    {.name = "count", .address_offset = address_of(offsetof(FindPlanes, addresses), 1)},
    {.name = "result", .access = Access::write, .address_offset = address_of(offsetof(FindPlanes, addresses), 2)},
};

constexpr std::uint32_t move_addresses = offsetof(MovePages, addresses);
constexpr Binding pack_bindings[] = {
    {.name = "list", .address_offset = address_of(move_addresses, 0)},
    {.name = "table", .address_offset = address_of(move_addresses, 1)},
    {.name = "frames", .address_offset = address_of(move_addresses, 2)},
    {.name = "packed", .access = Access::write, .address_offset = address_of(move_addresses, 3)},
};
constexpr Binding unpack_bindings[] = {
    {.name = "list", .address_offset = address_of(move_addresses, 0)},
    {.name = "table", .address_offset = address_of(move_addresses, 1)},
    {.name = "frames", .access = Access::write, .address_offset = address_of(move_addresses, 2)},
    {.name = "packed", .address_offset = address_of(move_addresses, 3)},
};

constexpr std::uint32_t take_addresses = offsetof(TakePages, addresses);
constexpr Binding take_bindings[] = {
    {.name = "list", .address_offset = address_of(take_addresses, 0)},
    {.name = "taken", .access = Access::write, .address_offset = address_of(take_addresses, 1)},
};

}  // namespace

const Kernel take_pages_kernel = {
    .name = "take_pages",
    .file = "",
    .line = 0,
    .rank = 1,
    .group = {64, 1, 1},
    .loop_rounds = 0,
    .bindings = take_bindings,
    .direct = {},
    .general = {.spirv = take_pages, .host = take_pages_on_host, .parameter_bytes = sizeof(TakePages)},
};

const Kernel find_planes_kernel = {
    .name = "find_planes",
    .file = "",
    .line = 0,
    .rank = 1,
    .group = {64, 1, 1},
    .loop_rounds = 33,
    .bindings = find_planes_bindings,
    .direct = {},
    .general = {.spirv = find_planes, .host = find_planes_on_host, .parameter_bytes = sizeof(FindPlanes)},
};

const Kernel pack_pages_kernel = {
    .name = "pack_pages",
    .file = "",
    .line = 0,
    .rank = 1,
    .group = {64, 1, 1},
    .loop_rounds = 0,
    .bindings = pack_bindings,
    .direct = {},
    .general = {.spirv = pack_pages, .host = pack_pages_on_host, .parameter_bytes = sizeof(MovePages)},
};

const Kernel unpack_pages_kernel = {
    .name = "unpack_pages",
    .file = "",
    .line = 0,
    .rank = 1,
    .group = {64, 1, 1},
    .loop_rounds = 0,
    .bindings = unpack_bindings,
    .direct = {},
    .general = {.spirv = unpack_pages, .host = unpack_pages_on_host, .parameter_bytes = sizeof(MovePages)},
};

}  // namespace glift::detail
