// Made by gliftc from fold.glift. Changes are lost when it is made again.
#include "fold.glift.types.hpp"

#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace fold {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// fold.glift:31: twice

namespace {
struct twice_direct_parameters {
    uint3 f_extent;
};
static_assert(offsetof(twice_direct_parameters, f_extent) == 0);

// fold.glift:31: runs kernel twice for the given rows.
GLIFT_HOST_KERNEL
static void twice_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const twice_direct_parameters*>(call.parameters);
    const uint3 f_extent = parameters.f_extent;
    const glift::HostMemory& f_data = call.memories[0];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint3 address{x, row.y, row.z};
            // fold.glift:31
            const uint f_i = (address.z * f_extent.y + address.y) * f_extent.x + address.x;
            const uint2 f_at = uint2(f_i % 64u, f_i / 64u);
            const int2 value = int2(f_at);
            const float f_value = glift::host::load_texel<glift::Format::r32f, float>(f_data, value);
            glift::host::store_texel<glift::Format::r32f, float>(f_data, value, 2.0f * f_value);
        }
    }
}

static void twice_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { twice_direct_rows(call, rows); });
}

struct twice_general_parameters {
    uint3 size;
    uint3 f_origin;
    uint3 f_extent;
};
static_assert(offsetof(twice_general_parameters, size) == 0);
static_assert(offsetof(twice_general_parameters, f_origin) == 12);
static_assert(offsetof(twice_general_parameters, f_extent) == 24);

// fold.glift:31: runs kernel twice for the given rows.
GLIFT_HOST_KERNEL
static void twice_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const twice_general_parameters*>(call.parameters);
    const uint3 f_origin = parameters.f_origin;
    const uint3 f_extent = parameters.f_extent;
    const glift::HostMemory& f_data = call.memories[0];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint3 address{x, row.y, row.z};
            // fold.glift:31
            const uint3 f_address = f_origin + address;
            const uint f_i = (f_address.z * f_extent.y + f_address.y) * f_extent.x + f_address.x;
            const uint2 f_at = uint2(f_i % 64u, f_i / 64u);
            const int2 value = int2(f_at);
            const float f_value = glift::host::load_texel<glift::Format::r32f, float>(f_data, value);
            glift::host::store_texel<glift::Format::r32f, float>(f_data, value, 2.0f * f_value);
        }
    }
}

static void twice_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { twice_general_rows(call, rows); });
}

struct twice_wide_parameters {
    uint3 size;
    uint3 f_origin;
    uint3 base;
    uint3 f_extent;
};
static_assert(offsetof(twice_wide_parameters, size) == 0);
static_assert(offsetof(twice_wide_parameters, f_origin) == 12);
static_assert(offsetof(twice_wide_parameters, base) == 24);
static_assert(offsetof(twice_wide_parameters, f_extent) == 36);

// fold.glift:31: runs kernel twice for the given rows.
GLIFT_HOST_KERNEL
static void twice_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const twice_wide_parameters*>(call.parameters);
    const uint3 f_origin = parameters.f_origin;
    const uint3 f_extent = parameters.f_extent;
    const glift::HostMemory& f_data = call.memories[0];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint3 address{x, row.y, row.z};
            // fold.glift:31
            const uint3 f_address = f_origin + address;
            const uint f_i = (f_address.z * f_extent.y + f_address.y) * f_extent.x + f_address.x;
            const uint2 f_at = uint2(f_i % 64u, f_i / 64u);
            const int2 value = int2(f_at);
            const float f_value = glift::host::load_texel<glift::Format::r32f, float>(f_data, value);
            glift::host::store_texel<glift::Format::r32f, float>(f_data, value, 2.0f * f_value);
        }
    }
}

static void twice_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { twice_wide_rows(call, rows); });
}

const glift::Binding twice_bindings[] = {
    {.name = "f.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::read_write},
};
constexpr glift::Parameter twice_parameters[] = {
    {"f_extent", 0, sizeof(twice_direct_parameters::f_extent)},
};
}  // namespace

extern const glift::Kernel twice_kernel;
const glift::Kernel twice_kernel = {
    .name = "twice",
    .file = "fold.glift",
    .line = 31,
    .rank = 3,
    .group = {32, 4, 2},
    .loop_rounds = 0,
    .bindings = twice_bindings,
    .direct = {.host = &twice_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &twice_general, .parameter_bytes = 36},
    .wide = {.host = &twice_wide, .parameter_bytes = 48, .base_offset = 24},
    .parameters = twice_parameters,
    .items = {1, 2, 1},
};

}  // namespace fold

