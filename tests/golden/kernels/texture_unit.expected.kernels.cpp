// Made by gliftc from texture_unit.glift. Changes are lost when it is made again.
#include "texture_unit.glift.types.hpp"

#include <glift/host/atomics.h>
#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace texture_unit {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// texture_unit.glift:20: splat

namespace {
struct splat_direct_parameters {
    uint p_extent;
    uint2 nearest_extent;
    uint farthest_extent;
    uint2 marks_extent;
    uint marks_data_extent_x;
};
static_assert(offsetof(splat_direct_parameters, p_extent) == 0);
static_assert(offsetof(splat_direct_parameters, nearest_extent) == 4);
static_assert(offsetof(splat_direct_parameters, farthest_extent) == 12);
static_assert(offsetof(splat_direct_parameters, marks_extent) == 16);
static_assert(offsetof(splat_direct_parameters, marks_data_extent_x) == 24);

// texture_unit.glift:20: runs kernel splat for the given rows.
GLIFT_HOST_KERNEL
static void splat_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const splat_direct_parameters*>(call.parameters);
    const uint2 nearest_extent = parameters.nearest_extent;
    const uint farthest_extent = parameters.farthest_extent;
    const uint2 marks_extent = parameters.marks_extent;
    const uint marks_data_extent_x = parameters.marks_data_extent_x;
    const float3* p_data = glift::host::elements<const float3>(call.memories[0]);
    const glift::HostMemory& nearest_data = call.memories[1];
    float* farthest_data = glift::host::elements<float>(call.memories[2]);
    const glift::HostMemory& marks_data = call.memories[3];
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            const float3* p_data_row = glift::host::row_pointer(p_data + address);
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // texture_unit.glift:22
                const float3 p_data_value = p_data_row[i];
                const uint2 nearest_address = uint2(p_data_value.xy());
                if (glift::all(glift::lessThan(nearest_address, nearest_extent))) {
                    glift::host::atomic_min(glift::host::texel<glift::Format::r32f,
                        float>(nearest_data, int2(nearest_address)), p_data_value.z);
                }
                // texture_unit.glift:23
                const uint farthest_address = glift::convert<uint>(p_data_value.x);
                if (farthest_address < farthest_extent) {
                    glift::host::atomic_max(farthest_data[farthest_address], p_data_value.z);
                }
                // texture_unit.glift:24
                if (glift::all(glift::lessThan(nearest_address, marks_extent))) {
                    const uint marks_index = nearest_address.y * marks_extent.x + nearest_address.x;
                    glift::host::memory::atomicCompareExchange(glift::host::texel<glift::Format::r32ui,
                        uint>(marks_data, int2(uint2(glift::remainder(marks_index, marks_data_extent_x),
                        glift::divide(marks_index, marks_data_extent_x)))), 0u, 7u);
                }
            }
        }
    }
}

static void splat_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { splat_direct_rows(call, rows); });
}

struct splat_general_parameters {
    uint size;
    uint p_origin;
    uint2 nearest_origin;
    uint2 nearest_size;
    uint farthest_origin;
    uint farthest_size;
    uint2 marks_origin;
    uint2 marks_size;
    uint marks_extent_x;
    uint marks_data_extent_x;
};
static_assert(offsetof(splat_general_parameters, size) == 0);
static_assert(offsetof(splat_general_parameters, p_origin) == 4);
static_assert(offsetof(splat_general_parameters, nearest_origin) == 8);
static_assert(offsetof(splat_general_parameters, nearest_size) == 16);
static_assert(offsetof(splat_general_parameters, farthest_origin) == 24);
static_assert(offsetof(splat_general_parameters, farthest_size) == 28);
static_assert(offsetof(splat_general_parameters, marks_origin) == 32);
static_assert(offsetof(splat_general_parameters, marks_size) == 40);
static_assert(offsetof(splat_general_parameters, marks_extent_x) == 48);
static_assert(offsetof(splat_general_parameters, marks_data_extent_x) == 52);

// texture_unit.glift:20: runs kernel splat for the given rows.
GLIFT_HOST_KERNEL
static void splat_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const splat_general_parameters*>(call.parameters);
    const uint p_origin = parameters.p_origin;
    const uint2 nearest_origin = parameters.nearest_origin;
    const uint2 nearest_size = parameters.nearest_size;
    const uint farthest_origin = parameters.farthest_origin;
    const uint farthest_size = parameters.farthest_size;
    const uint2 marks_origin = parameters.marks_origin;
    const uint2 marks_size = parameters.marks_size;
    const uint marks_extent_x = parameters.marks_extent_x;
    const uint marks_data_extent_x = parameters.marks_data_extent_x;
    const float3* p_data = glift::host::elements<const float3>(call.memories[0]);
    const glift::HostMemory& nearest_data = call.memories[1];
    float* farthest_data = glift::host::elements<float>(call.memories[2]);
    const glift::HostMemory& marks_data = call.memories[3];
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // texture_unit.glift:22
            const uint p_address = p_origin + address;
            const float3* p_data_row = glift::host::row_pointer(p_data + p_address);
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // texture_unit.glift:22
                const float3 p_data_value = p_data_row[i];
                const uint2 nearest_address = uint2(p_data_value.xy());
                const uint2 nearest_virtual = nearest_origin + nearest_address;
                if (glift::all(glift::lessThan(nearest_address, nearest_size))) {
                    glift::host::atomic_min(glift::host::texel<glift::Format::r32f,
                        float>(nearest_data, int2(nearest_virtual)), p_data_value.z);
                }
                // texture_unit.glift:23
                const uint farthest_address = glift::convert<uint>(p_data_value.x);
                const uint farthest_virtual = farthest_origin + farthest_address;
                if (farthest_address < farthest_size) {
                    glift::host::atomic_max(farthest_data[farthest_virtual], p_data_value.z);
                }
                // texture_unit.glift:24
                const uint2 marks_virtual = marks_origin + nearest_address;
                if (glift::all(glift::lessThan(nearest_address, marks_size))) {
                    const uint marks_index = marks_virtual.y * marks_extent_x + marks_virtual.x;
                    glift::host::memory::atomicCompareExchange(glift::host::texel<glift::Format::r32ui,
                        uint>(marks_data, int2(uint2(glift::remainder(marks_index, marks_data_extent_x),
                        glift::divide(marks_index, marks_data_extent_x)))), 0u, 7u);
                }
            }
        }
    }
}

static void splat_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { splat_general_rows(call, rows); });
}

struct splat_wide_parameters {
    uint size;
    uint p_origin;
    uint2 nearest_origin;
    uint2 nearest_size;
    uint farthest_origin;
    uint farthest_size;
    uint2 marks_origin;
    uint2 marks_size;
    uint marks_extent_x;
    uint marks_data_extent_x;
    std::uint64_t p_data_address;
    std::uint64_t farthest_data_address;
};
static_assert(offsetof(splat_wide_parameters, size) == 0);
static_assert(offsetof(splat_wide_parameters, p_origin) == 4);
static_assert(offsetof(splat_wide_parameters, nearest_origin) == 8);
static_assert(offsetof(splat_wide_parameters, nearest_size) == 16);
static_assert(offsetof(splat_wide_parameters, farthest_origin) == 24);
static_assert(offsetof(splat_wide_parameters, farthest_size) == 28);
static_assert(offsetof(splat_wide_parameters, marks_origin) == 32);
static_assert(offsetof(splat_wide_parameters, marks_size) == 40);
static_assert(offsetof(splat_wide_parameters, marks_extent_x) == 48);
static_assert(offsetof(splat_wide_parameters, marks_data_extent_x) == 52);
static_assert(offsetof(splat_wide_parameters, p_data_address) == 56);
static_assert(offsetof(splat_wide_parameters, farthest_data_address) == 64);

// texture_unit.glift:20: runs kernel splat for the given rows.
GLIFT_HOST_KERNEL
static void splat_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const splat_wide_parameters*>(call.parameters);
    const uint p_origin = parameters.p_origin;
    const uint2 nearest_origin = parameters.nearest_origin;
    const uint2 nearest_size = parameters.nearest_size;
    const uint farthest_origin = parameters.farthest_origin;
    const uint farthest_size = parameters.farthest_size;
    const uint2 marks_origin = parameters.marks_origin;
    const uint2 marks_size = parameters.marks_size;
    const uint marks_extent_x = parameters.marks_extent_x;
    const uint marks_data_extent_x = parameters.marks_data_extent_x;
    const float3* p_data = glift::host::elements<const float3>(call.memories[0]);
    const glift::HostMemory& nearest_data = call.memories[1];
    float* farthest_data = glift::host::elements<float>(call.memories[2]);
    const glift::HostMemory& marks_data = call.memories[3];
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // texture_unit.glift:22
            const uint p_address = p_origin + address;
            // texture_unit.glift:20
            const std::uint64_t p_at = std::uint64_t(p_address);
            // texture_unit.glift:22
            const float3 p_data_value = p_data[p_at];
            const uint2 nearest_address = uint2(p_data_value.xy());
            const uint2 nearest_virtual = nearest_origin + nearest_address;
            if (glift::all(glift::lessThan(nearest_address, nearest_size))) {
                glift::host::atomic_min(glift::host::texel<glift::Format::r32f,
                    float>(nearest_data, int2(nearest_virtual)), p_data_value.z);
            }
            // texture_unit.glift:23
            const uint farthest_address = glift::convert<uint>(p_data_value.x);
            const uint farthest_virtual = farthest_origin + farthest_address;
            if (farthest_address < farthest_size) {
                glift::host::atomic_max(farthest_data[std::uint64_t(farthest_virtual)], p_data_value.z);
            }
            // texture_unit.glift:24
            const uint2 marks_virtual = marks_origin + nearest_address;
            if (glift::all(glift::lessThan(nearest_address, marks_size))) {
                const uint marks_index = marks_virtual.y * marks_extent_x + marks_virtual.x;
                glift::host::memory::atomicCompareExchange(glift::host::texel<glift::Format::r32ui,
                    uint>(marks_data, int2(uint2(glift::remainder(marks_index, marks_data_extent_x),
                    glift::divide(marks_index, marks_data_extent_x)))), 0u, 7u);
            }
        }
    }
}

static void splat_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { splat_wide_rows(call, rows); });
}

const glift::Binding splat_bindings[] = {
    {.name = "p.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 56,
        .element_bytes = sizeof(float3), .reach = glift::Reach::element},
    {.name = "nearest.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::read_write, .as_bits = true,
        .parameter = 1, .reach = glift::Reach::range, .combine = glift::Combine::min},
    {.name = "farthest.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read_write,
        .address_offset = 64, .element_bytes = sizeof(float), .parameter = 2, .reach = glift::Reach::range,
        .combine = glift::Combine::max},
    {.name = "marks.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::read_write, .parameter = 3,
        .reach = glift::Reach::range, .combine = glift::Combine::coherent},
};
constexpr glift::Parameter splat_parameters[] = {
    {"p_extent", 0, sizeof(splat_direct_parameters::p_extent)},
    {"nearest_extent", 4, sizeof(splat_direct_parameters::nearest_extent)},
    {"farthest_extent", 12, sizeof(splat_direct_parameters::farthest_extent)},
    {"marks_extent", 16, sizeof(splat_direct_parameters::marks_extent)},
    {"marks_data_extent_x", 24, sizeof(splat_direct_parameters::marks_data_extent_x)},
};
}  // namespace

extern const glift::Kernel splat_kernel;
const glift::Kernel splat_kernel = {
    .name = "splat",
    .file = "texture_unit.glift",
    .line = 20,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = splat_bindings,
    .direct = {.host = &splat_direct, .parameter_bytes = 28, .push_constants = true},
    .general = {.host = &splat_general, .parameter_bytes = 56},
    .wide = {.host = &splat_wide, .parameter_bytes = 72},
    .parameters = splat_parameters,
};

// ----------------------------------------------------------------------------------------------------
// texture_unit.glift:27: light

namespace {
struct light_direct_parameters {
    uint p_extent;
    float2 heights_data_extent;
    uint3 shadows_domain;
    float shadows_depths_extent_x;
    float shadows_depths_extent_y;
};
static_assert(offsetof(light_direct_parameters, p_extent) == 0);
static_assert(offsetof(light_direct_parameters, heights_data_extent) == 4);
static_assert(offsetof(light_direct_parameters, shadows_domain) == 12);
static_assert(offsetof(light_direct_parameters, shadows_depths_extent_x) == 24);
static_assert(offsetof(light_direct_parameters, shadows_depths_extent_y) == 28);

// texture_unit.glift:27: runs kernel light for the given rows.
GLIFT_HOST_KERNEL
static void light_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const light_direct_parameters*>(call.parameters);
    const float2 heights_data_extent = parameters.heights_data_extent;
    const uint3 shadows_domain = parameters.shadows_domain;
    const float shadows_depths_extent_x = parameters.shadows_depths_extent_x;
    const float shadows_depths_extent_y = parameters.shadows_depths_extent_y;
    float3* p_data = glift::host::elements<float3>(call.memories[0]);
    const glift::HostMemory& shadows_depths_compared = call.memories[1];
    const glift::HostMemory& heights_data = call.memories[2];
    const glift::HostMemory& shadows_depths = call.memories[3];
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            float3* p_data_row = glift::host::row_pointer(p_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // texture_unit.glift:28
                const float3 p_value = p_data_row[i];
                const float2 heights_lower = p_value.xy() - float2(0.5f);
                const float2 heights_corner = glift::floor(heights_lower);
                const float4 heights_texels = glift::host::gather<glift::Format::r32f,
                    float>(heights_data, (heights_corner + float2(1.0f)) / heights_data_extent);
                const float2 heights_weight = heights_lower - heights_corner;
                const uint3 shadows_address = uint3(p_value);
                const bool shadows_value_inside = glift::all(glift::lessThan(shadows_address, shadows_domain));
                const float shadows_value = glift::host::load_texel<glift::Format::d32,
                    float>(shadows_depths, int3(shadows_value_inside ? shadows_address : uint3(0u)));
                const float share = glift::host::compare_linear<glift::Format::d32,
                    glift::Compare::less>(shadows_depths_compared,
                    float3(p_value.x / shadows_depths_extent_x, p_value.y / shadows_depths_extent_y,
                    glift::floor(p_value.z)), 0.5f) * glift::mix(glift::mix(p_value.z <= heights_texels.x ? 1.0f : 0.0f,
                    p_value.z <= heights_texels.y ? 1.0f : 0.0f, heights_weight.x),
                    glift::mix(p_value.z <= heights_texels.z ? 1.0f : 0.0f, p_value.z <= heights_texels.w ? 1.0f : 0.0f,
                    heights_weight.x), heights_weight.y) * (shadows_value_inside ? shadows_value : 0.0f);
                // texture_unit.glift:29
                p_data_row[i] = float3(share, glift::swizzle<1, 3>(heights_texels));
            }
        }
    }
}

static void light_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { light_direct_rows(call, rows); });
}

struct light_general_parameters {
    uint size;
    uint p_origin;
    uint3 shadows_origin;
    uint2 heights_origin;
    uint3 shadows_size;
    float2 heights_data_extent;
    float shadows_depths_extent_x;
    float shadows_depths_extent_y;
};
static_assert(offsetof(light_general_parameters, size) == 0);
static_assert(offsetof(light_general_parameters, p_origin) == 4);
static_assert(offsetof(light_general_parameters, shadows_origin) == 8);
static_assert(offsetof(light_general_parameters, heights_origin) == 20);
static_assert(offsetof(light_general_parameters, shadows_size) == 28);
static_assert(offsetof(light_general_parameters, heights_data_extent) == 40);
static_assert(offsetof(light_general_parameters, shadows_depths_extent_x) == 48);
static_assert(offsetof(light_general_parameters, shadows_depths_extent_y) == 52);

// texture_unit.glift:27: runs kernel light for the given rows.
GLIFT_HOST_KERNEL
static void light_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const light_general_parameters*>(call.parameters);
    const uint p_origin = parameters.p_origin;
    const uint3 shadows_origin = parameters.shadows_origin;
    const uint2 heights_origin = parameters.heights_origin;
    const uint3 shadows_size = parameters.shadows_size;
    const float2 heights_data_extent = parameters.heights_data_extent;
    const float shadows_depths_extent_x = parameters.shadows_depths_extent_x;
    const float shadows_depths_extent_y = parameters.shadows_depths_extent_y;
    float3* p_data = glift::host::elements<float3>(call.memories[0]);
    const glift::HostMemory& shadows_depths_compared = call.memories[1];
    const glift::HostMemory& heights_data = call.memories[2];
    const glift::HostMemory& shadows_depths = call.memories[3];
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // texture_unit.glift:28
            const uint p_address = p_origin + address;
            float3* p_data_row = glift::host::row_pointer(p_data + p_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // texture_unit.glift:28
                const float3 p_value = p_data_row[i];
                const float2 heights_lower = p_value.xy() + float2(heights_origin) - float2(0.5f);
                const float2 heights_corner = glift::floor(heights_lower);
                const float4 heights_texels = glift::host::gather<glift::Format::r32f,
                    float>(heights_data, (heights_corner + float2(1.0f)) / heights_data_extent);
                const float2 heights_weight = heights_lower - heights_corner;
                const uint3 shadows_address = uint3(p_value);
                const uint3 shadows_virtual = shadows_origin + shadows_address;
                const bool shadows_value_inside = glift::all(glift::lessThan(shadows_address, shadows_size));
                const float shadows_value = glift::host::load_texel<glift::Format::d32,
                    float>(shadows_depths, int3(shadows_value_inside ? shadows_virtual : uint3(0u)));
                const float share = glift::host::compare_linear<glift::Format::d32,
                    glift::Compare::less>(shadows_depths_compared,
                    float3((p_value.x + float(shadows_origin.x)) / shadows_depths_extent_x,
                    (p_value.y + float(shadows_origin.y)) / shadows_depths_extent_y,
                    glift::floor(p_value.z + float(shadows_origin.z))),
                    0.5f) * glift::mix(glift::mix(p_value.z <= heights_texels.x ? 1.0f : 0.0f,
                    p_value.z <= heights_texels.y ? 1.0f : 0.0f, heights_weight.x),
                    glift::mix(p_value.z <= heights_texels.z ? 1.0f : 0.0f, p_value.z <= heights_texels.w ? 1.0f : 0.0f,
                    heights_weight.x), heights_weight.y) * (shadows_value_inside ? shadows_value : 0.0f);
                // texture_unit.glift:29
                p_data_row[i] = float3(share, glift::swizzle<1, 3>(heights_texels));
            }
        }
    }
}

static void light_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { light_general_rows(call, rows); });
}

struct light_wide_parameters {
    uint size;
    uint p_origin;
    uint3 shadows_origin;
    uint2 heights_origin;
    uint3 shadows_size;
    float2 heights_data_extent;
    float shadows_depths_extent_x;
    float shadows_depths_extent_y;
    std::uint64_t p_data_address;
};
static_assert(offsetof(light_wide_parameters, size) == 0);
static_assert(offsetof(light_wide_parameters, p_origin) == 4);
static_assert(offsetof(light_wide_parameters, shadows_origin) == 8);
static_assert(offsetof(light_wide_parameters, heights_origin) == 20);
static_assert(offsetof(light_wide_parameters, shadows_size) == 28);
static_assert(offsetof(light_wide_parameters, heights_data_extent) == 40);
static_assert(offsetof(light_wide_parameters, shadows_depths_extent_x) == 48);
static_assert(offsetof(light_wide_parameters, shadows_depths_extent_y) == 52);
static_assert(offsetof(light_wide_parameters, p_data_address) == 56);

// texture_unit.glift:27: runs kernel light for the given rows.
GLIFT_HOST_KERNEL
static void light_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const light_wide_parameters*>(call.parameters);
    const uint p_origin = parameters.p_origin;
    const uint3 shadows_origin = parameters.shadows_origin;
    const uint2 heights_origin = parameters.heights_origin;
    const uint3 shadows_size = parameters.shadows_size;
    const float2 heights_data_extent = parameters.heights_data_extent;
    const float shadows_depths_extent_x = parameters.shadows_depths_extent_x;
    const float shadows_depths_extent_y = parameters.shadows_depths_extent_y;
    float3* p_data = glift::host::elements<float3>(call.memories[0]);
    const glift::HostMemory& shadows_depths_compared = call.memories[1];
    const glift::HostMemory& heights_data = call.memories[2];
    const glift::HostMemory& shadows_depths = call.memories[3];
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // texture_unit.glift:28
            const uint p_address = p_origin + address;
            // texture_unit.glift:27
            const std::uint64_t p_at = std::uint64_t(p_address);
            // texture_unit.glift:28
            const float3 p_value = p_data[p_at];
            const float2 heights_lower = p_value.xy() + float2(heights_origin) - float2(0.5f);
            const float2 heights_corner = glift::floor(heights_lower);
            const float4 heights_texels = glift::host::gather<glift::Format::r32f,
                float>(heights_data, (heights_corner + float2(1.0f)) / heights_data_extent);
            const float2 heights_weight = heights_lower - heights_corner;
            const uint3 shadows_address = uint3(p_value);
            const uint3 shadows_virtual = shadows_origin + shadows_address;
            const bool shadows_value_inside = glift::all(glift::lessThan(shadows_address, shadows_size));
            const float shadows_value = glift::host::load_texel<glift::Format::d32,
                float>(shadows_depths, int3(shadows_value_inside ? shadows_virtual : uint3(0u)));
            const float share = glift::host::compare_linear<glift::Format::d32,
                glift::Compare::less>(shadows_depths_compared,
                float3((p_value.x + float(shadows_origin.x)) / shadows_depths_extent_x,
                (p_value.y + float(shadows_origin.y)) / shadows_depths_extent_y,
                glift::floor(p_value.z + float(shadows_origin.z))),
                0.5f) * glift::mix(glift::mix(p_value.z <= heights_texels.x ? 1.0f : 0.0f, p_value.z <= heights_texels.y
                ? 1.0f : 0.0f, heights_weight.x),
                glift::mix(p_value.z <= heights_texels.z ? 1.0f : 0.0f, p_value.z <= heights_texels.w ? 1.0f : 0.0f,
                heights_weight.x), heights_weight.y) * (shadows_value_inside ? shadows_value : 0.0f);
            // texture_unit.glift:29
            p_data[p_at] = float3(share, glift::swizzle<1, 3>(heights_texels));
        }
    }
}

static void light_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { light_wide_rows(call, rows); });
}

const glift::Binding light_bindings[] = {
    {.name = "p.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read_write, .address_offset = 56,
        .element_bytes = sizeof(float3)},
    {.name = "shadows.depths", .kind = glift::MemoryKind::image2darray, .access = glift::Access::read, .sampled = true,
        .sampler = {.filter = glift::Filter::linear, .compare = glift::Compare::less}},
    {.name = "heights.data", .kind = glift::MemoryKind::image2d, .access = glift::Access::read, .sampled = true,
        .sampler = {.filter = glift::Filter::linear}},
    {.name = "shadows.depths", .kind = glift::MemoryKind::image2darray, .access = glift::Access::read, .sampled = true},
};
constexpr glift::Parameter light_parameters[] = {
    {"p_extent", 0, sizeof(light_direct_parameters::p_extent)},
    {"heights_data_extent", 4, sizeof(light_direct_parameters::heights_data_extent)},
    {"shadows_domain", 12, sizeof(light_direct_parameters::shadows_domain)},
    {"shadows_depths_extent_x", 24, sizeof(light_direct_parameters::shadows_depths_extent_x)},
    {"shadows_depths_extent_y", 28, sizeof(light_direct_parameters::shadows_depths_extent_y)},
};
}  // namespace

extern const glift::Kernel light_kernel;
const glift::Kernel light_kernel = {
    .name = "light",
    .file = "texture_unit.glift",
    .line = 27,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = light_bindings,
    .direct = {.host = &light_direct, .parameter_bytes = 32, .push_constants = true},
    .general = {.host = &light_general, .parameter_bytes = 56},
    .wide = {.host = &light_wide, .parameter_bytes = 64},
    .parameters = light_parameters,
    .items = {2, 1, 1},
};

}  // namespace texture_unit

