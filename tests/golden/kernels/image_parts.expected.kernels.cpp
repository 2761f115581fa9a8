// Made by gliftc from image_parts.glift. Changes are lost when it is made again.
#include "image_parts.glift.types.hpp"

#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace image_parts {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// image_parts.glift:11: halve

namespace {
struct halve_direct_parameters {
    uint2 fine_data_extent;
};
static_assert(offsetof(halve_direct_parameters, fine_data_extent) == 0);

// image_parts.glift:11: runs kernel halve for the given rows.
GLIFT_HOST_KERNEL
static void halve_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const halve_direct_parameters*>(call.parameters);
    const uint2 fine_data_extent = parameters.fine_data_extent;
    const glift::HostMemory& fine_data = call.memories[0];
    const glift::HostMemory& to_data = call.memories[1];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // image_parts.glift:11
            const uint2 fine_address = 2u * address;
            const bool fine_value_inside = glift::all(glift::lessThan(fine_address, fine_data_extent));
            const float fine_value = glift::host::load_texel<glift::Format::r32f,
                float>(fine_data, int2(fine_value_inside ? fine_address : uint2(0u)));
            glift::host::store_texel<glift::Format::r32f,
                float>(to_data, int2(address), fine_value_inside ? fine_value : 0.0f);
        }
    }
}

static void halve_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { halve_direct_rows(call, rows); });
}

struct halve_general_parameters {
    uint2 size;
    uint2 a_origin;
    uint2 fine_origin;
    uint2 fine_size;
    uint2 to_origin;
};
static_assert(offsetof(halve_general_parameters, size) == 0);
static_assert(offsetof(halve_general_parameters, a_origin) == 8);
static_assert(offsetof(halve_general_parameters, fine_origin) == 16);
static_assert(offsetof(halve_general_parameters, fine_size) == 24);
static_assert(offsetof(halve_general_parameters, to_origin) == 32);

// image_parts.glift:11: runs kernel halve for the given rows.
GLIFT_HOST_KERNEL
static void halve_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const halve_general_parameters*>(call.parameters);
    const uint2 a_origin = parameters.a_origin;
    const uint2 fine_origin = parameters.fine_origin;
    const uint2 fine_size = parameters.fine_size;
    const uint2 to_origin = parameters.to_origin;
    const glift::HostMemory& fine_data = call.memories[0];
    const glift::HostMemory& to_data = call.memories[1];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // image_parts.glift:11
            const uint2 a_address = a_origin + address;
            const uint2 to_address = to_origin + address;
            const uint2 fine_address = 2u * a_address;
            const uint2 fine_virtual = fine_origin + fine_address;
            const bool fine_value_inside = glift::all(glift::lessThan(fine_address, fine_size));
            const float fine_value = glift::host::load_texel<glift::Format::r32f,
                float>(fine_data, int2(fine_value_inside ? fine_virtual : uint2(0u)));
            glift::host::store_texel<glift::Format::r32f,
                float>(to_data, int2(to_address), fine_value_inside ? fine_value : 0.0f);
        }
    }
}

static void halve_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { halve_general_rows(call, rows); });
}

struct halve_wide_parameters {
    uint2 size;
    uint2 a_origin;
    uint2 fine_origin;
    uint2 fine_size;
    uint2 to_origin;
    uint3 base;
};
static_assert(offsetof(halve_wide_parameters, size) == 0);
static_assert(offsetof(halve_wide_parameters, a_origin) == 8);
static_assert(offsetof(halve_wide_parameters, fine_origin) == 16);
static_assert(offsetof(halve_wide_parameters, fine_size) == 24);
static_assert(offsetof(halve_wide_parameters, to_origin) == 32);
static_assert(offsetof(halve_wide_parameters, base) == 40);

// image_parts.glift:11: runs kernel halve for the given rows.
GLIFT_HOST_KERNEL
static void halve_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const halve_wide_parameters*>(call.parameters);
    const uint2 a_origin = parameters.a_origin;
    const uint2 fine_origin = parameters.fine_origin;
    const uint2 fine_size = parameters.fine_size;
    const uint2 to_origin = parameters.to_origin;
    const glift::HostMemory& fine_data = call.memories[0];
    const glift::HostMemory& to_data = call.memories[1];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // image_parts.glift:11
            const uint2 a_address = a_origin + address;
            const uint2 to_address = to_origin + address;
            const uint2 fine_address = 2u * a_address;
            const uint2 fine_virtual = fine_origin + fine_address;
            const bool fine_value_inside = glift::all(glift::lessThan(fine_address, fine_size));
            const float fine_value = glift::host::load_texel<glift::Format::r32f,
                float>(fine_data, int2(fine_value_inside ? fine_virtual : uint2(0u)));
            glift::host::store_texel<glift::Format::r32f,
                float>(to_data, int2(to_address), fine_value_inside ? fine_value : 0.0f);
        }
    }
}

static void halve_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { halve_wide_rows(call, rows); });
}

const glift::Binding halve_bindings[] = {
    {.name = "fine.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::read, .sampled = true,
        .sampler = {.filter = glift::Filter::linear}, .reach = glift::Reach::range},
    {.name = "to.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::write, .parameter = 2,
        .reach = glift::Reach::element},
};
constexpr glift::Parameter halve_parameters[] = {
    {"fine_data_extent", 0, sizeof(halve_direct_parameters::fine_data_extent)},
};
}  // namespace

extern const glift::Kernel halve_kernel;
const glift::Kernel halve_kernel = {
    .name = "halve",
    .file = "image_parts.glift",
    .line = 11,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = halve_bindings,
    .direct = {.host = &halve_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &halve_general, .parameter_bytes = 40},
    .wide = {.host = &halve_wide, .parameter_bytes = 52, .base_offset = 40},
    .parameters = halve_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// image_parts.glift:13: resample

namespace {
struct resample_direct_parameters {
    uint2 a_data_extent;
    float2 from_data_extent;
    float level;
    float layers_data_extent_x;
    float layers_data_extent_y;
};
static_assert(offsetof(resample_direct_parameters, a_data_extent) == 0);
static_assert(offsetof(resample_direct_parameters, from_data_extent) == 8);
static_assert(offsetof(resample_direct_parameters, level) == 16);
static_assert(offsetof(resample_direct_parameters, layers_data_extent_x) == 20);
static_assert(offsetof(resample_direct_parameters, layers_data_extent_y) == 24);

// image_parts.glift:13: runs kernel resample for the given rows.
GLIFT_HOST_KERNEL
static void resample_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const resample_direct_parameters*>(call.parameters);
    const float2 from_data_extent = parameters.from_data_extent;
    const float level = parameters.level;
    const float layers_data_extent_x = parameters.layers_data_extent_x;
    const float layers_data_extent_y = parameters.layers_data_extent_y;
    const glift::HostMemory& from_data = call.memories[0];
    const glift::HostMemory& layers_data = call.memories[1];
    const glift::HostMemory& to_data = call.memories[2];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // image_parts.glift:14
            const float2 from_point = float2(address);
            const float3 layers_point = float3(from_point, 1.5f);
            glift::host::store_texel<glift::Format::rgba8,
                float4>(to_data, int2(address), glift::host::sample_linear<glift::Format::r32f,
                float>(from_data, from_point / from_data_extent,
                level) * glift::host::sample_linear<glift::Format::rgba8,
                float4>(layers_data, float3(layers_point.x / layers_data_extent_x,
                layers_point.y / layers_data_extent_y, glift::floor(layers_point.z))));
        }
    }
}

static void resample_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { resample_direct_rows(call, rows); });
}

struct resample_general_parameters {
    uint2 size;
    uint2 a_origin;
    uint2 from_origin;
    uint3 layers_origin;
    uint2 to_origin;
    float2 from_data_extent;
    float level;
    float layers_data_extent_x;
    float layers_data_extent_y;
};
static_assert(offsetof(resample_general_parameters, size) == 0);
static_assert(offsetof(resample_general_parameters, a_origin) == 8);
static_assert(offsetof(resample_general_parameters, from_origin) == 16);
static_assert(offsetof(resample_general_parameters, layers_origin) == 24);
static_assert(offsetof(resample_general_parameters, to_origin) == 36);
static_assert(offsetof(resample_general_parameters, from_data_extent) == 44);
static_assert(offsetof(resample_general_parameters, level) == 52);
static_assert(offsetof(resample_general_parameters, layers_data_extent_x) == 56);
static_assert(offsetof(resample_general_parameters, layers_data_extent_y) == 60);

// image_parts.glift:13: runs kernel resample for the given rows.
GLIFT_HOST_KERNEL
static void resample_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const resample_general_parameters*>(call.parameters);
    const uint2 a_origin = parameters.a_origin;
    const uint2 from_origin = parameters.from_origin;
    const uint3 layers_origin = parameters.layers_origin;
    const uint2 to_origin = parameters.to_origin;
    const float2 from_data_extent = parameters.from_data_extent;
    const float level = parameters.level;
    const float layers_data_extent_x = parameters.layers_data_extent_x;
    const float layers_data_extent_y = parameters.layers_data_extent_y;
    const glift::HostMemory& from_data = call.memories[0];
    const glift::HostMemory& layers_data = call.memories[1];
    const glift::HostMemory& to_data = call.memories[2];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // image_parts.glift:14
            const uint2 a_address = a_origin + address;
            const uint2 to_address = to_origin + address;
            const float2 from_point = float2(a_address);
            const float3 layers_point = float3(from_point, 1.5f);
            glift::host::store_texel<glift::Format::rgba8,
                float4>(to_data, int2(to_address), glift::host::sample_linear<glift::Format::r32f,
                float>(from_data, (from_point + float2(from_origin)) / from_data_extent,
                level) * glift::host::sample_linear<glift::Format::rgba8,
                float4>(layers_data, float3((layers_point.x + float(layers_origin.x)) / layers_data_extent_x,
                (layers_point.y + float(layers_origin.y)) / layers_data_extent_y,
                glift::floor(layers_point.z + float(layers_origin.z)))));
        }
    }
}

static void resample_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { resample_general_rows(call, rows); });
}

struct resample_wide_parameters {
    uint2 size;
    uint2 a_origin;
    uint2 from_origin;
    uint3 layers_origin;
    uint2 to_origin;
    uint3 base;
    float2 from_data_extent;
    float level;
    float layers_data_extent_x;
    float layers_data_extent_y;
};
static_assert(offsetof(resample_wide_parameters, size) == 0);
static_assert(offsetof(resample_wide_parameters, a_origin) == 8);
static_assert(offsetof(resample_wide_parameters, from_origin) == 16);
static_assert(offsetof(resample_wide_parameters, layers_origin) == 24);
static_assert(offsetof(resample_wide_parameters, to_origin) == 36);
static_assert(offsetof(resample_wide_parameters, base) == 44);
static_assert(offsetof(resample_wide_parameters, from_data_extent) == 56);
static_assert(offsetof(resample_wide_parameters, level) == 64);
static_assert(offsetof(resample_wide_parameters, layers_data_extent_x) == 68);
static_assert(offsetof(resample_wide_parameters, layers_data_extent_y) == 72);

// image_parts.glift:13: runs kernel resample for the given rows.
GLIFT_HOST_KERNEL
static void resample_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const resample_wide_parameters*>(call.parameters);
    const uint2 a_origin = parameters.a_origin;
    const uint2 from_origin = parameters.from_origin;
    const uint3 layers_origin = parameters.layers_origin;
    const uint2 to_origin = parameters.to_origin;
    const float2 from_data_extent = parameters.from_data_extent;
    const float level = parameters.level;
    const float layers_data_extent_x = parameters.layers_data_extent_x;
    const float layers_data_extent_y = parameters.layers_data_extent_y;
    const glift::HostMemory& from_data = call.memories[0];
    const glift::HostMemory& layers_data = call.memories[1];
    const glift::HostMemory& to_data = call.memories[2];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // image_parts.glift:14
            const uint2 a_address = a_origin + address;
            const uint2 to_address = to_origin + address;
            const float2 from_point = float2(a_address);
            const float3 layers_point = float3(from_point, 1.5f);
            glift::host::store_texel<glift::Format::rgba8,
                float4>(to_data, int2(to_address), glift::host::sample_linear<glift::Format::r32f,
                float>(from_data, (from_point + float2(from_origin)) / from_data_extent,
                level) * glift::host::sample_linear<glift::Format::rgba8,
                float4>(layers_data, float3((layers_point.x + float(layers_origin.x)) / layers_data_extent_x,
                (layers_point.y + float(layers_origin.y)) / layers_data_extent_y,
                glift::floor(layers_point.z + float(layers_origin.z)))));
        }
    }
}

static void resample_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { resample_wide_rows(call, rows); });
}

const glift::Binding resample_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::read, .sampled = true,
        .sampler = {.filter = glift::Filter::linear}, .reach = glift::Reach::range},
    {.name = "layers.data", .kind = glift::MemoryKind::image2darray, .access = glift::Access::read, .sampled = true,
        .sampler = {.filter = glift::Filter::linear}, .parameter = 1, .reach = glift::Reach::range},
    {.name = "to.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::write, .parameter = 3,
        .reach = glift::Reach::element},
};
constexpr glift::Parameter resample_parameters[] = {
    {"a_data_extent", 0, sizeof(resample_direct_parameters::a_data_extent)},
    {"from_data_extent", 8, sizeof(resample_direct_parameters::from_data_extent)},
    {"level", 16, sizeof(resample_direct_parameters::level)},
    {"layers_data_extent_x", 20, sizeof(resample_direct_parameters::layers_data_extent_x)},
    {"layers_data_extent_y", 24, sizeof(resample_direct_parameters::layers_data_extent_y)},
};
}  // namespace

extern const glift::Kernel resample_kernel;
const glift::Kernel resample_kernel = {
    .name = "resample",
    .file = "image_parts.glift",
    .line = 13,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = resample_bindings,
    .direct = {.host = &resample_direct, .parameter_bytes = 28, .push_constants = true},
    .general = {.host = &resample_general, .parameter_bytes = 64},
    .wide = {.host = &resample_wide, .parameter_bytes = 76, .base_offset = 44},
    .parameters = resample_parameters,
    .items = {1, 2, 1},
};

}  // namespace image_parts

