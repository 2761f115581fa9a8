// Made by gliftc from scatter.glift. Changes are lost when it is made again.
#include "scatter.glift.types.hpp"

#include <glift/host/atomics.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace scatter {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// scatter.glift:9: histogram

namespace {
struct histogram_direct_parameters {
    uint s_extent;
    uint bins_extent;
};
static_assert(offsetof(histogram_direct_parameters, s_extent) == 0);
static_assert(offsetof(histogram_direct_parameters, bins_extent) == 4);

// scatter.glift:9: runs kernel histogram for the given rows.
GLIFT_HOST_KERNEL
static void histogram_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const histogram_direct_parameters*>(call.parameters);
    const uint bins_extent = parameters.bins_extent;
    const uint* s_data = glift::host::elements<const uint>(call.memories[0]);
    uint* bins_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            const uint* s_data_row = glift::host::row_pointer(s_data + address);
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // scatter.glift:9
                const uint bins_address = s_data_row[i] % 64u;
                if (bins_address < bins_extent) {
                    glift::host::atomic_add(bins_data[bins_address], 1u);
                }
            }
        }
    }
}

static void histogram_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { histogram_direct_rows(call, rows); });
}

struct histogram_general_parameters {
    uint size;
    uint s_origin;
    uint bins_origin;
    uint bins_size;
};
static_assert(offsetof(histogram_general_parameters, size) == 0);
static_assert(offsetof(histogram_general_parameters, s_origin) == 4);
static_assert(offsetof(histogram_general_parameters, bins_origin) == 8);
static_assert(offsetof(histogram_general_parameters, bins_size) == 12);

// scatter.glift:9: runs kernel histogram for the given rows.
GLIFT_HOST_KERNEL
static void histogram_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const histogram_general_parameters*>(call.parameters);
    const uint s_origin = parameters.s_origin;
    const uint bins_origin = parameters.bins_origin;
    const uint bins_size = parameters.bins_size;
    const uint* s_data = glift::host::elements<const uint>(call.memories[0]);
    uint* bins_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // scatter.glift:9
            const uint s_address = s_origin + address;
            const uint* s_data_row = glift::host::row_pointer(s_data + s_address);
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // scatter.glift:9
                const uint bins_address = s_data_row[i] % 64u;
                const uint bins_virtual = bins_origin + bins_address;
                if (bins_address < bins_size) {
                    glift::host::atomic_add(bins_data[bins_virtual], 1u);
                }
            }
        }
    }
}

static void histogram_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { histogram_general_rows(call, rows); });
}

struct histogram_wide_parameters {
    uint size;
    uint s_origin;
    uint bins_origin;
    uint bins_size;
    std::uint64_t s_data_address;
    std::uint64_t bins_data_address;
};
static_assert(offsetof(histogram_wide_parameters, size) == 0);
static_assert(offsetof(histogram_wide_parameters, s_origin) == 4);
static_assert(offsetof(histogram_wide_parameters, bins_origin) == 8);
static_assert(offsetof(histogram_wide_parameters, bins_size) == 12);
static_assert(offsetof(histogram_wide_parameters, s_data_address) == 16);
static_assert(offsetof(histogram_wide_parameters, bins_data_address) == 24);

// scatter.glift:9: runs kernel histogram for the given rows.
GLIFT_HOST_KERNEL
static void histogram_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const histogram_wide_parameters*>(call.parameters);
    const uint s_origin = parameters.s_origin;
    const uint bins_origin = parameters.bins_origin;
    const uint bins_size = parameters.bins_size;
    const uint* s_data = glift::host::elements<const uint>(call.memories[0]);
    uint* bins_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // scatter.glift:9
            const uint s_address = s_origin + address;
            const std::uint64_t s_at = std::uint64_t(s_address);
            const uint bins_address = s_data[s_at] % 64u;
            const uint bins_virtual = bins_origin + bins_address;
            if (bins_address < bins_size) {
                glift::host::atomic_add(bins_data[std::uint64_t(bins_virtual)], 1u);
            }
        }
    }
}

static void histogram_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { histogram_wide_rows(call, rows); });
}

const glift::Binding histogram_bindings[] = {
    {.name = "s.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .element_bytes = sizeof(uint), .reach = glift::Reach::element},
    {.name = "bins.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read_write, .address_offset = 24,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::range, .combine = glift::Combine::add},
};
constexpr glift::Parameter histogram_parameters[] = {
    {"s_extent", 0, sizeof(histogram_direct_parameters::s_extent)},
    {"bins_extent", 4, sizeof(histogram_direct_parameters::bins_extent)},
};
}  // namespace

extern const glift::Kernel histogram_kernel;
const glift::Kernel histogram_kernel = {
    .name = "histogram",
    .file = "scatter.glift",
    .line = 9,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = histogram_bindings,
    .direct = {.host = &histogram_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &histogram_general, .parameter_bytes = 16},
    .wide = {.host = &histogram_wide, .parameter_bytes = 32},
    .parameters = histogram_parameters,
};

}  // namespace scatter

