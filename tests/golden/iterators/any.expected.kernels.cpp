// Made by gliftc from any.glift. Changes are lost when it is made again.
#include "any.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace any {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// any.glift:9: gather

namespace {
struct gather_direct_parameters {
    uint index_extent;
    uint values_extent;
};
static_assert(offsetof(gather_direct_parameters, index_extent) == 0);
static_assert(offsetof(gather_direct_parameters, values_extent) == 4);

// any.glift:9: runs kernel gather for the given rows.
GLIFT_HOST_KERNEL
static void gather_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const gather_direct_parameters*>(call.parameters);
    const uint values_extent = parameters.values_extent;
    const uint* index_data = glift::host::elements<const uint>(call.memories[0]);
    const float* values_data = glift::host::elements<const float>(call.memories[1]);
    float* g_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            const uint* index_data_row = glift::host::row_pointer(index_data + address);
            float* g_data_row = glift::host::row_pointer(g_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // any.glift:9
                const uint values_address = index_data_row[i];
                const bool values_value_inside = values_address < values_extent;
                const float values_value = values_data[values_value_inside ? values_address : 0u];
                g_data_row[i] = values_value_inside ? values_value : 0.0f;
            }
        }
    }
}

static void gather_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { gather_direct_rows(call, rows); });
}

struct gather_general_parameters {
    uint size;
    uint index_origin;
    uint values_origin;
    uint values_size;
    uint g_origin;
};
static_assert(offsetof(gather_general_parameters, size) == 0);
static_assert(offsetof(gather_general_parameters, index_origin) == 4);
static_assert(offsetof(gather_general_parameters, values_origin) == 8);
static_assert(offsetof(gather_general_parameters, values_size) == 12);
static_assert(offsetof(gather_general_parameters, g_origin) == 16);

// any.glift:9: runs kernel gather for the given rows.
GLIFT_HOST_KERNEL
static void gather_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const gather_general_parameters*>(call.parameters);
    const uint index_origin = parameters.index_origin;
    const uint values_origin = parameters.values_origin;
    const uint values_size = parameters.values_size;
    const uint g_origin = parameters.g_origin;
    const uint* index_data = glift::host::elements<const uint>(call.memories[0]);
    const float* values_data = glift::host::elements<const float>(call.memories[1]);
    float* g_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // any.glift:9
            const uint index_address = index_origin + address;
            const uint g_address = g_origin + address;
            const uint* index_data_row = glift::host::row_pointer(index_data + index_address);
            float* g_data_row = glift::host::row_pointer(g_data + g_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // any.glift:9
                const uint values_address = index_data_row[i];
                const uint values_virtual = values_origin + values_address;
                const bool values_value_inside = values_address < values_size;
                const float values_value = values_data[values_value_inside ? values_virtual : 0u];
                g_data_row[i] = values_value_inside ? values_value : 0.0f;
            }
        }
    }
}

static void gather_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { gather_general_rows(call, rows); });
}

struct gather_wide_parameters {
    uint size;
    uint index_origin;
    uint values_origin;
    uint values_size;
    uint g_origin;
    std::uint64_t index_data_address;
    std::uint64_t values_data_address;
    std::uint64_t g_data_address;
};
static_assert(offsetof(gather_wide_parameters, size) == 0);
static_assert(offsetof(gather_wide_parameters, index_origin) == 4);
static_assert(offsetof(gather_wide_parameters, values_origin) == 8);
static_assert(offsetof(gather_wide_parameters, values_size) == 12);
static_assert(offsetof(gather_wide_parameters, g_origin) == 16);
static_assert(offsetof(gather_wide_parameters, index_data_address) == 24);
static_assert(offsetof(gather_wide_parameters, values_data_address) == 32);
static_assert(offsetof(gather_wide_parameters, g_data_address) == 40);

// any.glift:9: runs kernel gather for the given rows.
GLIFT_HOST_KERNEL
static void gather_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const gather_wide_parameters*>(call.parameters);
    const uint index_origin = parameters.index_origin;
    const uint values_origin = parameters.values_origin;
    const uint values_size = parameters.values_size;
    const uint g_origin = parameters.g_origin;
    const uint* index_data = glift::host::elements<const uint>(call.memories[0]);
    const float* values_data = glift::host::elements<const float>(call.memories[1]);
    float* g_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // any.glift:9
            const uint index_address = index_origin + address;
            const std::uint64_t index_at = std::uint64_t(index_address);
            const uint g_address = g_origin + address;
            const std::uint64_t g_at = std::uint64_t(g_address);
            const uint values_address = index_data[index_at];
            const uint values_virtual = values_origin + values_address;
            const bool values_value_inside = values_address < values_size;
            const std::uint64_t values_value_at = std::uint64_t(values_virtual);
            const float values_value = values_data[values_value_inside ? values_value_at : std::uint64_t{0u}];
            g_data[g_at] = values_value_inside ? values_value : 0.0f;
        }
    }
}

static void gather_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { gather_wide_rows(call, rows); });
}

const glift::Binding gather_bindings[] = {
    {.name = "index.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::element},
    {.name = "values.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 32,
        .element_bytes = sizeof(float), .reach = glift::Reach::range},
    {.name = "g.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 40,
        .element_bytes = sizeof(float), .parameter = 2, .reach = glift::Reach::element},
};
constexpr glift::Parameter gather_parameters[] = {
    {"index_extent", 0, sizeof(gather_direct_parameters::index_extent)},
    {"values_extent", 4, sizeof(gather_direct_parameters::values_extent)},
};
}  // namespace

extern const glift::Kernel gather_kernel;
const glift::Kernel gather_kernel = {
    .name = "gather",
    .file = "any.glift",
    .line = 9,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = gather_bindings,
    .direct = {.host = &gather_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &gather_general, .parameter_bytes = 20},
    .wide = {.host = &gather_wide, .parameter_bytes = 48},
    .parameters = gather_parameters,
    .items = {2, 1, 1},
};

}  // namespace any

