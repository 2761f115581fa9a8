// Made by gliftc from composed.glift. Changes are lost when it is made again.
#include "composed.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace composed {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// composed.glift:24: copy

namespace {
struct copy_direct_parameters {
    uint2 f_extent;
};
static_assert(offsetof(copy_direct_parameters, f_extent) == 0);

// composed.glift:24: runs kernel copy for the given rows.
GLIFT_HOST_KERNEL
static void copy_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const copy_direct_parameters*>(call.parameters);
    const uint2 f_extent = parameters.f_extent;
    const float* f_data = glift::host::elements<const float>(call.memories[0]);
    float* g_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // composed.glift:24
            const uint f_at = address.x * f_extent.y + address.y;
            g_data[f_at] = f_data[f_at];
        }
    }
}

static void copy_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { copy_direct_rows(call, rows); });
}

struct copy_general_parameters {
    uint2 size;
    uint2 f_origin;
    uint2 g_origin;
    uint f_extent_y;
    uint g_extent_y;
};
static_assert(offsetof(copy_general_parameters, size) == 0);
static_assert(offsetof(copy_general_parameters, f_origin) == 8);
static_assert(offsetof(copy_general_parameters, g_origin) == 16);
static_assert(offsetof(copy_general_parameters, f_extent_y) == 24);
static_assert(offsetof(copy_general_parameters, g_extent_y) == 28);

// composed.glift:24: runs kernel copy for the given rows.
GLIFT_HOST_KERNEL
static void copy_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const copy_general_parameters*>(call.parameters);
    const uint2 f_origin = parameters.f_origin;
    const uint2 g_origin = parameters.g_origin;
    const uint f_extent_y = parameters.f_extent_y;
    const uint g_extent_y = parameters.g_extent_y;
    const float* f_data = glift::host::elements<const float>(call.memories[0]);
    float* g_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // composed.glift:24
            const uint2 f_address = f_origin + address;
            const uint f_at = f_address.x * f_extent_y + f_address.y;
            const uint2 g_address = g_origin + address;
            const uint g_at = g_address.x * g_extent_y + g_address.y;
            const float f_value = f_data[f_at];
            g_data[g_at] = f_value;
        }
    }
}

static void copy_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { copy_general_rows(call, rows); });
}

struct copy_wide_parameters {
    uint2 size;
    uint2 f_origin;
    uint2 g_origin;
    uint3 base;
    std::uint64_t f_extent_y;
    std::uint64_t g_extent_y;
    std::uint64_t f_data_address;
    std::uint64_t g_data_address;
};
static_assert(offsetof(copy_wide_parameters, size) == 0);
static_assert(offsetof(copy_wide_parameters, f_origin) == 8);
static_assert(offsetof(copy_wide_parameters, g_origin) == 16);
static_assert(offsetof(copy_wide_parameters, base) == 24);
static_assert(offsetof(copy_wide_parameters, f_extent_y) == 40);
static_assert(offsetof(copy_wide_parameters, g_extent_y) == 48);
static_assert(offsetof(copy_wide_parameters, f_data_address) == 56);
static_assert(offsetof(copy_wide_parameters, g_data_address) == 64);

// composed.glift:24: runs kernel copy for the given rows.
GLIFT_HOST_KERNEL
static void copy_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const copy_wide_parameters*>(call.parameters);
    const uint2 f_origin = parameters.f_origin;
    const uint2 g_origin = parameters.g_origin;
    const std::uint64_t f_extent_y = parameters.f_extent_y;
    const std::uint64_t g_extent_y = parameters.g_extent_y;
    const float* f_data = glift::host::elements<const float>(call.memories[0]);
    float* g_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // composed.glift:24
            const uint2 f_address = f_origin + address;
            const std::uint64_t f_at = std::uint64_t(f_address.x) * f_extent_y + std::uint64_t(f_address.y);
            const uint2 g_address = g_origin + address;
            const std::uint64_t g_at = std::uint64_t(g_address.x) * g_extent_y + std::uint64_t(g_address.y);
            const float f_value = f_data[f_at];
            g_data[g_at] = f_value;
        }
    }
}

static void copy_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { copy_wide_rows(call, rows); });
}

const glift::Binding copy_bindings[] = {
    {.name = "f.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 56,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "g.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 64,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter copy_parameters[] = {
    {"f_extent", 0, sizeof(copy_direct_parameters::f_extent)},
};
}  // namespace

extern const glift::Kernel copy_kernel;
const glift::Kernel copy_kernel = {
    .name = "copy",
    .file = "composed.glift",
    .line = 24,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = copy_bindings,
    .direct = {.host = &copy_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &copy_general, .parameter_bytes = 32},
    .wide = {.host = &copy_wide, .parameter_bytes = 72, .base_offset = 24},
    .parameters = copy_parameters,
    .items = {1, 2, 1},
};

}  // namespace composed

