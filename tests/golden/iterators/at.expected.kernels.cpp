// Made by gliftc from at.glift. Changes are lost when it is made again.
#include "at.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace at {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// at.glift:8: ramp

namespace {
struct ramp_direct_parameters {
    uint2 a_extent;
};
static_assert(offsetof(ramp_direct_parameters, a_extent) == 0);

// at.glift:8: runs kernel ramp for the given rows.
GLIFT_HOST_KERNEL
static void ramp_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const ramp_direct_parameters*>(call.parameters);
    const uint2 a_extent = parameters.a_extent;
    float* f_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // at.glift:8
            const uint a_at = address.y * a_extent.x + address.x;
            float* f_data_row = glift::host::row_pointer(f_data + a_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint2 address{row.begin + static_cast<uint>(i), row.y};
                // at.glift:8
                f_data_row[i] = float(address.x) + 10.0f * float(address.y);
            }
        }
    }
}

static void ramp_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { ramp_direct_rows(call, rows); });
}

struct ramp_general_parameters {
    uint2 size;
    uint2 a_origin;
    uint2 f_origin;
    uint f_extent_x;
};
static_assert(offsetof(ramp_general_parameters, size) == 0);
static_assert(offsetof(ramp_general_parameters, a_origin) == 8);
static_assert(offsetof(ramp_general_parameters, f_origin) == 16);
static_assert(offsetof(ramp_general_parameters, f_extent_x) == 24);

// at.glift:8: runs kernel ramp for the given rows.
GLIFT_HOST_KERNEL
static void ramp_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const ramp_general_parameters*>(call.parameters);
    const uint2 a_origin = parameters.a_origin;
    const uint2 f_origin = parameters.f_origin;
    const uint f_extent_x = parameters.f_extent_x;
    float* f_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // at.glift:8
            const uint2 f_address = f_origin + address;
            const uint f_at = f_address.y * f_extent_x + f_address.x;
            float* f_data_row = glift::host::row_pointer(f_data + f_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint2 address{row.begin + static_cast<uint>(i), row.y};
                // at.glift:8
                const uint2 a_address = a_origin + address;
                f_data_row[i] = float(a_address.x) + 10.0f * float(a_address.y);
            }
        }
    }
}

static void ramp_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { ramp_general_rows(call, rows); });
}

struct ramp_wide_parameters {
    uint2 size;
    uint2 a_origin;
    uint2 f_origin;
    uint3 base;
    std::uint64_t f_extent_x;
    std::uint64_t f_data_address;
};
static_assert(offsetof(ramp_wide_parameters, size) == 0);
static_assert(offsetof(ramp_wide_parameters, a_origin) == 8);
static_assert(offsetof(ramp_wide_parameters, f_origin) == 16);
static_assert(offsetof(ramp_wide_parameters, base) == 24);
static_assert(offsetof(ramp_wide_parameters, f_extent_x) == 40);
static_assert(offsetof(ramp_wide_parameters, f_data_address) == 48);

// at.glift:8: runs kernel ramp for the given rows.
GLIFT_HOST_KERNEL
static void ramp_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const ramp_wide_parameters*>(call.parameters);
    const uint2 a_origin = parameters.a_origin;
    const uint2 f_origin = parameters.f_origin;
    const std::uint64_t f_extent_x = parameters.f_extent_x;
    float* f_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // at.glift:8
            const uint2 a_address = a_origin + address;
            const uint2 f_address = f_origin + address;
            const std::uint64_t f_at = std::uint64_t(f_address.y) * f_extent_x + std::uint64_t(f_address.x);
            f_data[f_at] = float(a_address.x) + 10.0f * float(a_address.y);
        }
    }
}

static void ramp_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { ramp_wide_rows(call, rows); });
}

const glift::Binding ramp_bindings[] = {
    {.name = "f.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 48,
        .element_bytes = sizeof(float)},
};
constexpr glift::Parameter ramp_parameters[] = {
    {"a_extent", 0, sizeof(ramp_direct_parameters::a_extent)},
};
}  // namespace

extern const glift::Kernel ramp_kernel;
const glift::Kernel ramp_kernel = {
    .name = "ramp",
    .file = "at.glift",
    .line = 8,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = ramp_bindings,
    .direct = {.host = &ramp_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &ramp_general, .parameter_bytes = 28},
    .wide = {.host = &ramp_wide, .parameter_bytes = 56, .base_offset = 24},
    .parameters = ramp_parameters,
    .items = {1, 2, 1},
};

}  // namespace at

