// Made by gliftc from calls.glift. Changes are lost when it is made again.
#include "calls.glift.types.hpp"

#include <glift/host/atomics.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace calls {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// calls.glift:29: push_even

namespace {
struct push_even_direct_parameters {
    uint x_extent;
    uint bag_capacity;
    uint bag_items_extent;
    glift::Bool x_extent_value_0;
};
static_assert(offsetof(push_even_direct_parameters, x_extent) == 0);
static_assert(offsetof(push_even_direct_parameters, bag_capacity) == 4);
static_assert(offsetof(push_even_direct_parameters, bag_items_extent) == 8);
static_assert(offsetof(push_even_direct_parameters, x_extent_value_0) == 12);

// calls.glift:29: runs kernel push_even for the given rows.
GLIFT_HOST_KERNEL
static void push_even_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const push_even_direct_parameters*>(call.parameters);
    const uint bag_capacity = parameters.bag_capacity;
    const uint bag_items_extent = parameters.bag_items_extent;
    const bool x_extent_value_0 = parameters.x_extent_value_0;
    const uint* x_data = glift::host::elements<const uint>(call.memories[0]);
    uint* bag_seen_data = glift::host::elements<uint>(call.memories[1]);
    uint* bag_top_data = glift::host::elements<uint>(call.memories[2]);
    uint* bag_items_data = glift::host::elements<uint>(call.memories[3]);
    uint* lost_data = glift::host::elements<uint>(call.memories[4]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            const uint* x_data_row = glift::host::row_pointer(x_data + address);
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // calls.glift:30
                const uint x_2 = x_data_row[i];
                if (x_2 % 2u == 0u && x_2 < bag_capacity) {
                    // calls.glift:31
                    uint push = 0u;
                    bool push_found = false;
                    // calls.glift:13
                    const uint bag_seen_address = x_2 / 32u;
                    if (bag_seen_address < 32u) {
                        glift::host::atomic_bit_or(bag_seen_data[bag_seen_address], 1u << ((x_2 % 32u) & 31));
                    }
                    // calls.glift:18
                    const uint bag_top_before = glift::host::memory::atomicAdd(bag_top_data[0u], 1u);
                    // calls.glift:31
                    if (bag_top_before >= bag_capacity) {
                        // calls.glift:20
                        push = 0u;
                        push_found = false;
                    } else {
                        // calls.glift:22
                        if (bag_top_before < bag_items_extent) {
                            bag_items_data[bag_top_before] = x_2;
                        }
                        // calls.glift:23
                        push = bag_top_before;
                        push_found = true;
                    }
                    // calls.glift:31
                    const uint found = push;
                    const bool found_found = push_found;
                    const uint place = found_found ? found : 4294967295u;
                    // calls.glift:32
                    if (place == 4294967295u) {
                        // calls.glift:33
                        if (x_extent_value_0) {
                            glift::host::atomic_add(lost_data[0u], 1u);
                        }
                    }
                }
            }
        }
    }
}

static void push_even_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { push_even_direct_rows(call, rows); });
}

struct push_even_general_parameters {
    uint size;
    uint x_origin;
    uint lost_origin;
    uint lost_size;
    uint bag_capacity;
    uint bag_items_extent;
};
static_assert(offsetof(push_even_general_parameters, size) == 0);
static_assert(offsetof(push_even_general_parameters, x_origin) == 4);
static_assert(offsetof(push_even_general_parameters, lost_origin) == 8);
static_assert(offsetof(push_even_general_parameters, lost_size) == 12);
static_assert(offsetof(push_even_general_parameters, bag_capacity) == 16);
static_assert(offsetof(push_even_general_parameters, bag_items_extent) == 20);

// calls.glift:29: runs kernel push_even for the given rows.
GLIFT_HOST_KERNEL
static void push_even_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const push_even_general_parameters*>(call.parameters);
    const uint x_origin = parameters.x_origin;
    const uint lost_origin = parameters.lost_origin;
    const uint lost_size = parameters.lost_size;
    const uint bag_capacity = parameters.bag_capacity;
    const uint bag_items_extent = parameters.bag_items_extent;
    const uint* x_data = glift::host::elements<const uint>(call.memories[0]);
    uint* bag_seen_data = glift::host::elements<uint>(call.memories[1]);
    uint* bag_top_data = glift::host::elements<uint>(call.memories[2]);
    uint* bag_items_data = glift::host::elements<uint>(call.memories[3]);
    uint* lost_data = glift::host::elements<uint>(call.memories[4]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // calls.glift:30
            const uint x_address = x_origin + address;
            const uint* x_data_row = glift::host::row_pointer(x_data + x_address);
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // calls.glift:30
                const uint x_2 = x_data_row[i];
                if (x_2 % 2u == 0u && x_2 < bag_capacity) {
                    // calls.glift:31
                    uint push = 0u;
                    bool push_found = false;
                    // calls.glift:13
                    const uint bag_seen_address = x_2 / 32u;
                    if (bag_seen_address < 32u) {
                        glift::host::atomic_bit_or(bag_seen_data[bag_seen_address], 1u << ((x_2 % 32u) & 31));
                    }
                    // calls.glift:18
                    const uint bag_top_before = glift::host::memory::atomicAdd(bag_top_data[0u], 1u);
                    // calls.glift:31
                    if (bag_top_before >= bag_capacity) {
                        // calls.glift:20
                        push = 0u;
                        push_found = false;
                    } else {
                        // calls.glift:22
                        if (bag_top_before < bag_items_extent) {
                            bag_items_data[bag_top_before] = x_2;
                        }
                        // calls.glift:23
                        push = bag_top_before;
                        push_found = true;
                    }
                    // calls.glift:31
                    const uint found = push;
                    const bool found_found = push_found;
                    const uint place = found_found ? found : 4294967295u;
                    // calls.glift:32
                    if (place == 4294967295u) {
                        // calls.glift:33
                        if (0u < lost_size) {
                            glift::host::atomic_add(lost_data[lost_origin], 1u);
                        }
                    }
                }
            }
        }
    }
}

static void push_even_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { push_even_general_rows(call, rows); });
}

struct push_even_wide_parameters {
    uint size;
    uint x_origin;
    uint lost_origin;
    uint lost_size;
    uint bag_capacity;
    uint bag_items_extent;
    std::uint64_t x_data_address;
    std::uint64_t bag_seen_data_address;
    std::uint64_t bag_top_data_address;
    std::uint64_t bag_items_data_address;
    std::uint64_t lost_data_address;
};
static_assert(offsetof(push_even_wide_parameters, size) == 0);
static_assert(offsetof(push_even_wide_parameters, x_origin) == 4);
static_assert(offsetof(push_even_wide_parameters, lost_origin) == 8);
static_assert(offsetof(push_even_wide_parameters, lost_size) == 12);
static_assert(offsetof(push_even_wide_parameters, bag_capacity) == 16);
static_assert(offsetof(push_even_wide_parameters, bag_items_extent) == 20);
static_assert(offsetof(push_even_wide_parameters, x_data_address) == 24);
static_assert(offsetof(push_even_wide_parameters, bag_seen_data_address) == 32);
static_assert(offsetof(push_even_wide_parameters, bag_top_data_address) == 40);
static_assert(offsetof(push_even_wide_parameters, bag_items_data_address) == 48);
static_assert(offsetof(push_even_wide_parameters, lost_data_address) == 56);

// calls.glift:29: runs kernel push_even for the given rows.
GLIFT_HOST_KERNEL
static void push_even_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const push_even_wide_parameters*>(call.parameters);
    const uint x_origin = parameters.x_origin;
    const uint lost_origin = parameters.lost_origin;
    const uint lost_size = parameters.lost_size;
    const uint bag_capacity = parameters.bag_capacity;
    const uint bag_items_extent = parameters.bag_items_extent;
    const uint* x_data = glift::host::elements<const uint>(call.memories[0]);
    uint* bag_seen_data = glift::host::elements<uint>(call.memories[1]);
    uint* bag_top_data = glift::host::elements<uint>(call.memories[2]);
    uint* bag_items_data = glift::host::elements<uint>(call.memories[3]);
    uint* lost_data = glift::host::elements<uint>(call.memories[4]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // calls.glift:30
            const uint x_address = x_origin + address;
            // calls.glift:29
            const std::uint64_t x_at = std::uint64_t(x_address);
            // calls.glift:30
            const uint x_2 = x_data[x_at];
            if (x_2 % 2u == 0u && x_2 < bag_capacity) {
                // calls.glift:31
                uint push = 0u;
                bool push_found = false;
                // calls.glift:13
                const uint bag_seen_address = x_2 / 32u;
                if (bag_seen_address < 32u) {
                    glift::host::atomic_bit_or(bag_seen_data[std::uint64_t(bag_seen_address)],
                        1u << ((x_2 % 32u) & 31));
                }
                // calls.glift:18
                const uint bag_top_before = glift::host::memory::atomicAdd(bag_top_data[std::uint64_t{0u}], 1u);
                // calls.glift:31
                if (bag_top_before >= bag_capacity) {
                    // calls.glift:20
                    push = 0u;
                    push_found = false;
                } else {
                    // calls.glift:22
                    if (bag_top_before < bag_items_extent) {
                        bag_items_data[std::uint64_t(bag_top_before)] = x_2;
                    }
                    // calls.glift:23
                    push = bag_top_before;
                    push_found = true;
                }
                // calls.glift:31
                const uint found = push;
                const bool found_found = push_found;
                const uint place = found_found ? found : 4294967295u;
                // calls.glift:32
                if (place == 4294967295u) {
                    // calls.glift:33
                    if (0u < lost_size) {
                        glift::host::atomic_add(lost_data[std::uint64_t(lost_origin)], 1u);
                    }
                }
            }
        }
    }
}

static void push_even_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { push_even_wide_rows(call, rows); });
}

const glift::Binding push_even_bindings[] = {
    {.name = "x.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24,
        .element_bytes = sizeof(uint), .reach = glift::Reach::element},
    {.name = "bag.seen.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read_write,
        .address_offset = 32, .element_bytes = sizeof(uint), .parameter = 1},
    {.name = "bag.top.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read_write,
        .address_offset = 40, .element_bytes = sizeof(uint), .parameter = 1, .combine = glift::Combine::coherent},
    {.name = "bag.items.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 48,
        .element_bytes = sizeof(uint), .parameter = 1},
    {.name = "lost.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read_write, .address_offset = 56,
        .element_bytes = sizeof(uint), .parameter = 2, .reach = glift::Reach::range, .combine = glift::Combine::add},
};
constexpr glift::Parameter push_even_parameters[] = {
    {"x_extent", 0, sizeof(push_even_direct_parameters::x_extent)},
    {"bag_capacity", 4, sizeof(push_even_direct_parameters::bag_capacity)},
    {"bag_items_extent", 8, sizeof(push_even_direct_parameters::bag_items_extent)},
    {"x_extent_value_0", 12, sizeof(push_even_direct_parameters::x_extent_value_0)},
};
}  // namespace

extern const glift::Kernel push_even_kernel;
const glift::Kernel push_even_kernel = {
    .name = "push_even",
    .file = "calls.glift",
    .line = 29,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = push_even_bindings,
    .direct = {.host = &push_even_direct, .parameter_bytes = 16, .push_constants = true},
    .general = {.host = &push_even_general, .parameter_bytes = 24},
    .wide = {.host = &push_even_wide, .parameter_bytes = 64},
    .parameters = push_even_parameters,
};

}  // namespace calls

