// Made by gliftc from frames.glift. Changes are lost when it is made again.
#include "frames.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace frames {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// frames.glift:34: double_there

namespace {
struct double_there_direct_parameters {
    uint s_frames_n;
    uint s_data_extent;
};
static_assert(offsetof(double_there_direct_parameters, s_frames_n) == 0);
static_assert(offsetof(double_there_direct_parameters, s_data_extent) == 4);

// frames.glift:34: runs kernel double_there for the given rows.
GLIFT_HOST_KERNEL
static void double_there_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const double_there_direct_parameters*>(call.parameters);
    const uint s_frames_n = parameters.s_frames_n;
    const uint s_data_extent = parameters.s_data_extent;
    const uint* g_frames_data = glift::host::elements<const uint>(call.memories[0]);
    float* g_data = glift::host::elements<float>(call.memories[1]);
    const uint* s_frames_data = glift::host::elements<const uint>(call.memories[2]);
    const float* s_data = glift::host::elements<const float>(call.memories[3]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // frames.glift:34
            const uint g_frames_address = address / 4u;
            const bool g_frames_value_inside = g_frames_address < s_frames_n;
            const uint g_frames_value = g_frames_data[g_frames_value_inside ? g_frames_address : 0u];
            const uint g_frame = g_frames_value_inside ? g_frames_value : 0u;
            const uint g_place = (g_frame - 1u) * 4u + address % 4u;
            const bool g_found = !(g_frame == 0u) && g_place < s_data_extent;
            const float g_value = g_data[g_found ? g_place : 0u];
            const uint s_address = address + 1u;
            const uint s_frames_address = s_address / 4u;
            const bool s_frames_value_inside = s_frames_address < s_frames_n;
            const uint s_frames_value = s_frames_data[s_frames_value_inside ? s_frames_address : 0u];
            const uint s_frame = s_frames_value_inside ? s_frames_value : 0u;
            const uint s_place = (s_frame - 1u) * 4u + s_address % 4u;
            const bool s_value_inside = !(s_frame == 0u) && s_place < s_data_extent;
            const float s_value = s_data[s_value_inside ? s_place : 0u];
            if (g_found) {
                g_data[g_place] = g_value + (s_value_inside ? s_value : -1.0f);
            }
        }
    }
}

static void double_there_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { double_there_direct_rows(call, rows); });
}

struct double_there_general_parameters {
    uint size;
    uint g_origin;
    uint s_origin;
    uint g_frames_n;
    uint g_data_extent;
    uint s_frames_n;
    uint s_data_extent;
};
static_assert(offsetof(double_there_general_parameters, size) == 0);
static_assert(offsetof(double_there_general_parameters, g_origin) == 4);
static_assert(offsetof(double_there_general_parameters, s_origin) == 8);
static_assert(offsetof(double_there_general_parameters, g_frames_n) == 12);
static_assert(offsetof(double_there_general_parameters, g_data_extent) == 16);
static_assert(offsetof(double_there_general_parameters, s_frames_n) == 20);
static_assert(offsetof(double_there_general_parameters, s_data_extent) == 24);

// frames.glift:34: runs kernel double_there for the given rows.
GLIFT_HOST_KERNEL
static void double_there_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const double_there_general_parameters*>(call.parameters);
    const uint g_origin = parameters.g_origin;
    const uint s_origin = parameters.s_origin;
    const uint g_frames_n = parameters.g_frames_n;
    const uint g_data_extent = parameters.g_data_extent;
    const uint s_frames_n = parameters.s_frames_n;
    const uint s_data_extent = parameters.s_data_extent;
    const uint* g_frames_data = glift::host::elements<const uint>(call.memories[0]);
    float* g_data = glift::host::elements<float>(call.memories[1]);
    const uint* s_frames_data = glift::host::elements<const uint>(call.memories[2]);
    const float* s_data = glift::host::elements<const float>(call.memories[3]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // frames.glift:34
            const uint g_address = g_origin + address;
            const uint g_frames_address = g_address / 4u;
            const bool g_frames_value_inside = g_frames_address < g_frames_n;
            const uint g_frames_value = g_frames_data[g_frames_value_inside ? g_frames_address : 0u];
            const uint g_frame = g_frames_value_inside ? g_frames_value : 0u;
            const uint g_place = (g_frame - 1u) * 4u + g_address % 4u;
            const bool g_found = !(g_frame == 0u) && g_place < g_data_extent;
            const float g_value = g_data[g_found ? g_place : 0u];
            const uint s_address = address + 1u;
            const uint s_virtual = s_origin + s_address;
            const uint s_frames_address = s_virtual / 4u;
            const bool s_frames_value_inside = s_frames_address < s_frames_n;
            const uint s_frames_value = s_frames_data[s_frames_value_inside ? s_frames_address : 0u];
            const uint s_frame = s_frames_value_inside ? s_frames_value : 0u;
            const uint s_place = (s_frame - 1u) * 4u + s_virtual % 4u;
            const bool s_value_inside = !(s_frame == 0u) && s_place < s_data_extent;
            const float s_value = s_data[s_value_inside ? s_place : 0u];
            if (g_found) {
                g_data[g_place] = g_value + (s_value_inside ? s_value : -1.0f);
            }
        }
    }
}

static void double_there_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { double_there_general_rows(call, rows); });
}

struct double_there_wide_parameters {
    uint size;
    uint g_origin;
    uint s_origin;
    uint g_frames_n;
    std::uint64_t g_data_extent;
    uint s_frames_n;
    std::uint64_t s_data_extent;
    std::uint64_t g_frames_data_address;
    std::uint64_t g_data_address;
    std::uint64_t s_frames_data_address;
    std::uint64_t s_data_address;
};
static_assert(offsetof(double_there_wide_parameters, size) == 0);
static_assert(offsetof(double_there_wide_parameters, g_origin) == 4);
static_assert(offsetof(double_there_wide_parameters, s_origin) == 8);
static_assert(offsetof(double_there_wide_parameters, g_frames_n) == 12);
static_assert(offsetof(double_there_wide_parameters, g_data_extent) == 16);
static_assert(offsetof(double_there_wide_parameters, s_frames_n) == 24);
static_assert(offsetof(double_there_wide_parameters, s_data_extent) == 32);
static_assert(offsetof(double_there_wide_parameters, g_frames_data_address) == 40);
static_assert(offsetof(double_there_wide_parameters, g_data_address) == 48);
static_assert(offsetof(double_there_wide_parameters, s_frames_data_address) == 56);
static_assert(offsetof(double_there_wide_parameters, s_data_address) == 64);

// frames.glift:34: runs kernel double_there for the given rows.
GLIFT_HOST_KERNEL
static void double_there_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const double_there_wide_parameters*>(call.parameters);
    const uint g_origin = parameters.g_origin;
    const uint s_origin = parameters.s_origin;
    const uint g_frames_n = parameters.g_frames_n;
    const std::uint64_t g_data_extent = parameters.g_data_extent;
    const uint s_frames_n = parameters.s_frames_n;
    const std::uint64_t s_data_extent = parameters.s_data_extent;
    const uint* g_frames_data = glift::host::elements<const uint>(call.memories[0]);
    float* g_data = glift::host::elements<float>(call.memories[1]);
    const uint* s_frames_data = glift::host::elements<const uint>(call.memories[2]);
    const float* s_data = glift::host::elements<const float>(call.memories[3]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // frames.glift:34
            const uint g_address = g_origin + address;
            const uint g_frames_address = g_address / 4u;
            const bool g_frames_value_inside = g_frames_address < g_frames_n;
            const uint g_frames_value = g_frames_data[std::uint64_t(g_frames_value_inside ? g_frames_address : 0u)];
            const uint g_frame = g_frames_value_inside ? g_frames_value : 0u;
            const std::uint64_t g_place = (std::uint64_t(g_frame) - std::uint64_t{1u}) * std::uint64_t{4u}
                + std::uint64_t(g_address % 4u);
            const bool g_found = !(g_frame == 0u) && g_place < g_data_extent;
            const float g_value = g_data[g_found ? g_place : std::uint64_t{0u}];
            const uint s_address = address + 1u;
            const uint s_virtual = s_origin + s_address;
            const uint s_frames_address = s_virtual / 4u;
            const bool s_frames_value_inside = s_frames_address < s_frames_n;
            const uint s_frames_value = s_frames_data[std::uint64_t(s_frames_value_inside ? s_frames_address : 0u)];
            const uint s_frame = s_frames_value_inside ? s_frames_value : 0u;
            const std::uint64_t s_place = (std::uint64_t(s_frame) - std::uint64_t{1u}) * std::uint64_t{4u}
                + std::uint64_t(s_virtual % 4u);
            const bool s_value_inside = !(s_frame == 0u) && s_place < s_data_extent;
            const float s_value = s_data[s_value_inside ? s_place : std::uint64_t{0u}];
            if (g_found) {
                g_data[g_place] = g_value + (s_value_inside ? s_value : -1.0f);
            }
        }
    }
}

static void double_there_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { double_there_wide_rows(call, rows); });
}

const glift::Binding double_there_bindings[] = {
    {.name = "g.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 40,
        .element_bytes = sizeof(uint), .parameter = 1},
    {.name = "g.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read_write, .address_offset = 48,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
    {.name = "s.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 56,
        .element_bytes = sizeof(uint)},
    {.name = "s.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 64,
        .element_bytes = sizeof(float), .reach = glift::Reach::range},
};
constexpr glift::Parameter double_there_parameters[] = {
    {"s_frames_n", 0, sizeof(double_there_direct_parameters::s_frames_n)},
    {"s_data_extent", 4, sizeof(double_there_direct_parameters::s_data_extent)},
};
}  // namespace

extern const glift::Kernel double_there_kernel;
const glift::Kernel double_there_kernel = {
    .name = "double_there",
    .file = "frames.glift",
    .line = 34,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = double_there_bindings,
    .direct = {.host = &double_there_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &double_there_general, .parameter_bytes = 28},
    .wide = {.host = &double_there_wide, .parameter_bytes = 72},
    .parameters = double_there_parameters,
    .items = {2, 1, 1},
};

}  // namespace frames

