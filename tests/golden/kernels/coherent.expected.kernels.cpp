// Made by gliftc from coherent.glift. Changes are lost when it is made again.
#include "coherent.glift.types.hpp"

#include <glift/host/atomics.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace coherent {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// coherent.glift:8: take_turns

namespace {
struct take_turns_direct_parameters {
    uint a_extent;
    uint state_value_inside;
    glift::Bool state_value_inside_2;
};
static_assert(offsetof(take_turns_direct_parameters, a_extent) == 0);
static_assert(offsetof(take_turns_direct_parameters, state_value_inside) == 4);
static_assert(offsetof(take_turns_direct_parameters, state_value_inside_2) == 8);

// coherent.glift:8: runs kernel take_turns for the given rows.
GLIFT_HOST_KERNEL
static void take_turns_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const take_turns_direct_parameters*>(call.parameters);
    const uint a_extent = parameters.a_extent;
    const uint state_value_inside = parameters.state_value_inside;
    const bool state_value_inside_2 = parameters.state_value_inside_2;
    uint* state_data = glift::host::elements<uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            uint* to_data_row = glift::host::row_pointer(to_data + address);
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint address = row.begin + static_cast<uint>(i);
                // coherent.glift:9
                const uint state_value = glift::host::memory::read(state_data[state_value_inside]);
                const uint state_value_2 = state_value_inside_2 ? state_value : 0u;
                // coherent.glift:10
                const uint state_address = address + 1u;
                if (state_address < a_extent) {
                    glift::host::memory::write(state_data[state_address], state_value_2);
                }
                // coherent.glift:11
                uint state_before = 0u;
                if (state_value_inside_2) {
                    state_before = glift::host::memory::atomicAdd(state_data[0u], 1u);
                }
                const uint state_value_3 = glift::host::memory::read(state_data[state_value_inside]);
                to_data_row[i] = state_before + (state_value_inside_2 ? state_value_3 : 0u) - state_value_2;
            }
        }
    }
}

static void take_turns_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { take_turns_direct_rows(call, rows); });
}

struct take_turns_general_parameters {
    uint size;
    uint state_origin;
    uint state_size;
    uint a_origin;
    uint to_origin;
};
static_assert(offsetof(take_turns_general_parameters, size) == 0);
static_assert(offsetof(take_turns_general_parameters, state_origin) == 4);
static_assert(offsetof(take_turns_general_parameters, state_size) == 8);
static_assert(offsetof(take_turns_general_parameters, a_origin) == 12);
static_assert(offsetof(take_turns_general_parameters, to_origin) == 16);

// coherent.glift:8: runs kernel take_turns for the given rows.
GLIFT_HOST_KERNEL
static void take_turns_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const take_turns_general_parameters*>(call.parameters);
    const uint state_origin = parameters.state_origin;
    const uint state_size = parameters.state_size;
    const uint a_origin = parameters.a_origin;
    const uint to_origin = parameters.to_origin;
    uint* state_data = glift::host::elements<uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // coherent.glift:11
            const uint to_address = to_origin + address;
            uint* to_data_row = glift::host::row_pointer(to_data + to_address);
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint address = row.begin + static_cast<uint>(i);
                // coherent.glift:10
                const uint a_address = a_origin + address;
                // coherent.glift:9
                const bool state_value_inside = 0u < state_size;
                const uint value = state_value_inside ? state_origin : 0u;
                const uint state_value = glift::host::memory::read(state_data[value]);
                const uint state_value_2 = state_value_inside ? state_value : 0u;
                // coherent.glift:10
                const uint state_address = a_address + 1u;
                const uint state_virtual = state_origin + state_address;
                if (state_address < state_size) {
                    glift::host::memory::write(state_data[state_virtual], state_value_2);
                }
                // coherent.glift:11
                uint state_before = 0u;
                if (state_value_inside) {
                    state_before = glift::host::memory::atomicAdd(state_data[state_origin], 1u);
                }
                const uint state_value_3 = glift::host::memory::read(state_data[value]);
                to_data_row[i] = state_before + (state_value_inside ? state_value_3 : 0u) - state_value_2;
            }
        }
    }
}

static void take_turns_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { take_turns_general_rows(call, rows); });
}

struct take_turns_wide_parameters {
    uint size;
    uint state_origin;
    uint state_size;
    uint a_origin;
    uint to_origin;
    std::uint64_t state_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(take_turns_wide_parameters, size) == 0);
static_assert(offsetof(take_turns_wide_parameters, state_origin) == 4);
static_assert(offsetof(take_turns_wide_parameters, state_size) == 8);
static_assert(offsetof(take_turns_wide_parameters, a_origin) == 12);
static_assert(offsetof(take_turns_wide_parameters, to_origin) == 16);
static_assert(offsetof(take_turns_wide_parameters, state_data_address) == 24);
static_assert(offsetof(take_turns_wide_parameters, to_data_address) == 32);

// coherent.glift:8: runs kernel take_turns for the given rows.
GLIFT_HOST_KERNEL
static void take_turns_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const take_turns_wide_parameters*>(call.parameters);
    const uint state_origin = parameters.state_origin;
    const uint state_size = parameters.state_size;
    const uint a_origin = parameters.a_origin;
    const uint to_origin = parameters.to_origin;
    uint* state_data = glift::host::elements<uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // coherent.glift:10
            const uint a_address = a_origin + address;
            // coherent.glift:11
            const uint to_address = to_origin + address;
            // coherent.glift:8
            const std::uint64_t to_at = std::uint64_t(to_address);
            // coherent.glift:9
            const bool state_value_inside = 0u < state_size;
            const std::uint64_t state_value_at = std::uint64_t(state_origin);
            const std::uint64_t value = state_value_inside ? state_value_at : std::uint64_t{0u};
            const uint state_value = glift::host::memory::read(state_data[value]);
            const uint state_value_2 = state_value_inside ? state_value : 0u;
            // coherent.glift:10
            const uint state_address = a_address + 1u;
            const uint state_virtual = state_origin + state_address;
            if (state_address < state_size) {
                glift::host::memory::write(state_data[std::uint64_t(state_virtual)], state_value_2);
            }
            // coherent.glift:11
            uint state_before = 0u;
            if (state_value_inside) {
                state_before = glift::host::memory::atomicAdd(state_data[state_value_at], 1u);
            }
            const uint state_value_3 = glift::host::memory::read(state_data[value]);
            to_data[to_at] = state_before + (state_value_inside ? state_value_3 : 0u) - state_value_2;
        }
    }
}

static void take_turns_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { take_turns_wide_rows(call, rows); });
}

const glift::Binding take_turns_bindings[] = {
    {.name = "state.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read_write, .address_offset = 24,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::range,
        .combine = glift::Combine::coherent},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 32,
        .element_bytes = sizeof(uint), .parameter = 2, .reach = glift::Reach::element},
};
constexpr glift::Parameter take_turns_parameters[] = {
    {"a_extent", 0, sizeof(take_turns_direct_parameters::a_extent)},
    {"state_value_inside", 4, sizeof(take_turns_direct_parameters::state_value_inside)},
    {"state_value_inside_2", 8, sizeof(take_turns_direct_parameters::state_value_inside_2)},
};
}  // namespace

extern const glift::Kernel take_turns_kernel;
const glift::Kernel take_turns_kernel = {
    .name = "take_turns",
    .file = "coherent.glift",
    .line = 8,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = take_turns_bindings,
    .direct = {.host = &take_turns_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &take_turns_general, .parameter_bytes = 20},
    .wide = {.host = &take_turns_wide, .parameter_bytes = 40},
    .parameters = take_turns_parameters,
};

}  // namespace coherent

