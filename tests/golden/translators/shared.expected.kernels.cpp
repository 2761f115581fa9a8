// Made by gliftc from shared.glift. Changes are lost when it is made again.
#include "shared.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace shared {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// shared.glift:38: add

namespace {
struct add_direct_parameters {
    uint f_extent;
    uint f_table_extent;
    uint2 f_frames_extent;
    uint g_field_extent;
    uint g_field_table_extent;
    uint2 g_field_frames_extent;
};
static_assert(offsetof(add_direct_parameters, f_extent) == 0);
static_assert(offsetof(add_direct_parameters, f_table_extent) == 4);
static_assert(offsetof(add_direct_parameters, f_frames_extent) == 8);
static_assert(offsetof(add_direct_parameters, g_field_extent) == 16);
static_assert(offsetof(add_direct_parameters, g_field_table_extent) == 20);
static_assert(offsetof(add_direct_parameters, g_field_frames_extent) == 24);

// shared.glift:38: runs kernel add for the given rows.
GLIFT_HOST_KERNEL
static void add_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const add_direct_parameters*>(call.parameters);
    const uint f_extent = parameters.f_extent;
    const uint f_table_extent = parameters.f_table_extent;
    const uint2 f_frames_extent = parameters.f_frames_extent;
    const uint g_field_extent = parameters.g_field_extent;
    const uint g_field_table_extent = parameters.g_field_table_extent;
    const uint2 g_field_frames_extent = parameters.g_field_frames_extent;
    const uint* f_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* f_frames_data = glift::host::elements<const float>(call.memories[1]);
    const uint* g_field_table_data = glift::host::elements<const uint>(call.memories[2]);
    const float* g_field_frames_data = glift::host::elements<const float>(call.memories[3]);
    const uint* to_table_data = glift::host::elements<const uint>(call.memories[4]);
    float* to_frames_data = glift::host::elements<float>(call.memories[5]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // shared.glift:38
            const bool test = address >= f_extent;
            bool f_either = test;
            if (!f_either) {
                const uint f_table_address = address / 16u;
                const bool f_table_value_inside = f_table_address < f_table_extent;
                const uint f_table_value = f_table_data[f_table_value_inside ? f_table_address : 0u];
                f_either = (f_table_value_inside ? f_table_value : 0u) == 0u;
            }
            uint2 f_result{};
            bool f_found{};
            if (f_either) {
                f_result = uint2(0u);
                f_found = false;
            } else {
                const uint f_table_address = address / 16u;
                const bool f_table_value_inside = f_table_address < f_table_extent;
                const uint f_table_value = f_table_data[f_table_value_inside ? f_table_address : 0u];
                f_result = uint2(address % 16u, (f_table_value_inside ? f_table_value : 0u) - 1u);
                f_found = true;
            }
            const uint2 f_place = f_result;
            const uint f_at = f_place.y * f_frames_extent.x + f_place.x;
            const bool f_found_2 = f_found && f_place.y < f_frames_extent.y;
            bool to_either = test;
            if (!to_either) {
                const uint to_table_address = address / 16u;
                const bool to_table_value_inside = to_table_address < f_table_extent;
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
                to_either = (to_table_value_inside ? to_table_value : 0u) == 0u;
            }
            uint2 to_result{};
            bool to_found{};
            if (to_either) {
                to_result = uint2(0u);
                to_found = false;
            } else {
                const uint to_table_address = address / 16u;
                const bool to_table_value_inside = to_table_address < f_table_extent;
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
                to_result = uint2(address % 16u, (to_table_value_inside ? to_table_value : 0u) - 1u);
                to_found = true;
            }
            const uint2 to_place = to_result;
            const uint to_at = to_place.y * f_frames_extent.x + to_place.x;
            const bool to_found_2 = to_found && to_place.y < f_frames_extent.y;
            // shared.glift:39
            const float f_value = f_frames_data[f_found_2 ? f_at : 0u];
            const uint value = address + 1u;
            bool g_xp1_field_either = value >= g_field_extent;
            if (!g_xp1_field_either) {
                const uint g_field_table_address = value / 16u;
                const bool g_field_table_value_inside = g_field_table_address < g_field_table_extent;
                const uint g_field_table_value = g_field_table_data[g_field_table_value_inside ? g_field_table_address
                    : 0u];
                g_xp1_field_either = (g_field_table_value_inside ? g_field_table_value : 0u) == 0u;
            }
            uint2 g_xp1_field_result{};
            bool g_xp1_field_found{};
            if (g_xp1_field_either) {
                g_xp1_field_result = uint2(0u);
                g_xp1_field_found = false;
            } else {
                const uint g_field_table_address = value / 16u;
                const bool g_field_table_value_inside = g_field_table_address < g_field_table_extent;
                const uint g_field_table_value = g_field_table_data[g_field_table_value_inside ? g_field_table_address
                    : 0u];
                g_xp1_field_result = uint2(value % 16u, (g_field_table_value_inside ? g_field_table_value : 0u) - 1u);
                g_xp1_field_found = true;
            }
            const uint2 g_xp1_field_place = g_xp1_field_result;
            const bool g_xp1_inside = g_xp1_field_found && g_xp1_field_place.y < g_field_frames_extent.y;
            const uint g_xp1_at = g_xp1_field_place.y * g_field_frames_extent.x + g_xp1_field_place.x;
            const float g_xp1 = g_field_frames_data[g_xp1_inside ? g_xp1_at : 0u];
            if (to_found_2) {
                to_frames_data[to_at] = (f_found_2 ? f_value : -1.0f) + (g_xp1_inside ? g_xp1 : -1.0f);
            }
        }
    }
}

static void add_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { add_direct_rows(call, rows); });
}

struct add_general_parameters {
    uint size;
    uint f_origin;
    uint g_origin;
    uint to_origin;
    uint f_extent;
    uint f_table_extent;
    uint2 f_frames_extent;
    uint to_extent;
    uint to_table_extent;
    uint2 to_frames_extent;
    uint g_field_extent;
    uint g_field_table_extent;
    uint2 g_field_frames_extent;
};
static_assert(offsetof(add_general_parameters, size) == 0);
static_assert(offsetof(add_general_parameters, f_origin) == 4);
static_assert(offsetof(add_general_parameters, g_origin) == 8);
static_assert(offsetof(add_general_parameters, to_origin) == 12);
static_assert(offsetof(add_general_parameters, f_extent) == 16);
static_assert(offsetof(add_general_parameters, f_table_extent) == 20);
static_assert(offsetof(add_general_parameters, f_frames_extent) == 24);
static_assert(offsetof(add_general_parameters, to_extent) == 32);
static_assert(offsetof(add_general_parameters, to_table_extent) == 36);
static_assert(offsetof(add_general_parameters, to_frames_extent) == 40);
static_assert(offsetof(add_general_parameters, g_field_extent) == 48);
static_assert(offsetof(add_general_parameters, g_field_table_extent) == 52);
static_assert(offsetof(add_general_parameters, g_field_frames_extent) == 56);

// shared.glift:38: runs kernel add for the given rows.
GLIFT_HOST_KERNEL
static void add_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const add_general_parameters*>(call.parameters);
    const uint f_origin = parameters.f_origin;
    const uint g_origin = parameters.g_origin;
    const uint to_origin = parameters.to_origin;
    const uint f_extent = parameters.f_extent;
    const uint f_table_extent = parameters.f_table_extent;
    const uint2 f_frames_extent = parameters.f_frames_extent;
    const uint to_extent = parameters.to_extent;
    const uint to_table_extent = parameters.to_table_extent;
    const uint2 to_frames_extent = parameters.to_frames_extent;
    const uint g_field_extent = parameters.g_field_extent;
    const uint g_field_table_extent = parameters.g_field_table_extent;
    const uint2 g_field_frames_extent = parameters.g_field_frames_extent;
    const uint* f_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* f_frames_data = glift::host::elements<const float>(call.memories[1]);
    const uint* g_field_table_data = glift::host::elements<const uint>(call.memories[2]);
    const float* g_field_frames_data = glift::host::elements<const float>(call.memories[3]);
    const uint* to_table_data = glift::host::elements<const uint>(call.memories[4]);
    float* to_frames_data = glift::host::elements<float>(call.memories[5]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // shared.glift:39
            const uint f_address = f_origin + address;
            // shared.glift:38
            bool f_either = f_address >= f_extent;
            if (!f_either) {
                const uint f_table_address = f_address / 16u;
                const bool f_table_value_inside = f_table_address < f_table_extent;
                const uint f_table_value = f_table_data[f_table_value_inside ? f_table_address : 0u];
                f_either = (f_table_value_inside ? f_table_value : 0u) == 0u;
            }
            uint2 f_result{};
            bool f_found{};
            if (f_either) {
                f_result = uint2(0u);
                f_found = false;
            } else {
                const uint f_table_address = f_address / 16u;
                const bool f_table_value_inside = f_table_address < f_table_extent;
                const uint f_table_value = f_table_data[f_table_value_inside ? f_table_address : 0u];
                f_result = uint2(f_address % 16u, (f_table_value_inside ? f_table_value : 0u) - 1u);
                f_found = true;
            }
            const uint2 f_place = f_result;
            const uint f_at = f_place.y * f_frames_extent.x + f_place.x;
            const bool f_found_2 = f_found && f_place.y < f_frames_extent.y;
            // shared.glift:39
            const uint g_address = g_origin + address;
            const uint to_address = to_origin + address;
            // shared.glift:38
            bool to_either = to_address >= to_extent;
            if (!to_either) {
                const uint to_table_address = to_address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
                to_either = (to_table_value_inside ? to_table_value : 0u) == 0u;
            }
            uint2 to_result{};
            bool to_found{};
            if (to_either) {
                to_result = uint2(0u);
                to_found = false;
            } else {
                const uint to_table_address = to_address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
                to_result = uint2(to_address % 16u, (to_table_value_inside ? to_table_value : 0u) - 1u);
                to_found = true;
            }
            const uint2 to_place = to_result;
            const uint to_at = to_place.y * to_frames_extent.x + to_place.x;
            const bool to_found_2 = to_found && to_place.y < to_frames_extent.y;
            // shared.glift:39
            const float f_value = f_frames_data[f_found_2 ? f_at : 0u];
            const uint value = g_address + 1u;
            bool g_xp1_field_either = value >= g_field_extent;
            if (!g_xp1_field_either) {
                const uint g_field_table_address = value / 16u;
                const bool g_field_table_value_inside = g_field_table_address < g_field_table_extent;
                const uint g_field_table_value = g_field_table_data[g_field_table_value_inside ? g_field_table_address
                    : 0u];
                g_xp1_field_either = (g_field_table_value_inside ? g_field_table_value : 0u) == 0u;
            }
            uint2 g_xp1_field_result{};
            bool g_xp1_field_found{};
            if (g_xp1_field_either) {
                g_xp1_field_result = uint2(0u);
                g_xp1_field_found = false;
            } else {
                const uint g_field_table_address = value / 16u;
                const bool g_field_table_value_inside = g_field_table_address < g_field_table_extent;
                const uint g_field_table_value = g_field_table_data[g_field_table_value_inside ? g_field_table_address
                    : 0u];
                g_xp1_field_result = uint2(value % 16u, (g_field_table_value_inside ? g_field_table_value : 0u) - 1u);
                g_xp1_field_found = true;
            }
            const uint2 g_xp1_field_place = g_xp1_field_result;
            const bool g_xp1_inside = g_xp1_field_found && g_xp1_field_place.y < g_field_frames_extent.y;
            const uint g_xp1_at = g_xp1_field_place.y * g_field_frames_extent.x + g_xp1_field_place.x;
            const float g_xp1 = g_field_frames_data[g_xp1_inside ? g_xp1_at : 0u];
            if (to_found_2) {
                to_frames_data[to_at] = (f_found_2 ? f_value : -1.0f) + (g_xp1_inside ? g_xp1 : -1.0f);
            }
        }
    }
}

static void add_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { add_general_rows(call, rows); });
}

struct add_wide_parameters {
    uint size;
    uint f_origin;
    uint g_origin;
    uint to_origin;
    uint f_extent;
    uint f_table_extent;
    std::uint64_t f_frames_extent_x;
    uint f_frames_extent_y;
    uint to_extent;
    uint to_table_extent;
    std::uint64_t to_frames_extent_x;
    uint to_frames_extent_y;
    uint g_field_extent;
    uint g_field_table_extent;
    uint g_field_frames_extent_y;
    std::uint64_t g_field_frames_extent_x;
    std::uint64_t f_table_data_address;
    std::uint64_t f_frames_data_address;
    std::uint64_t g_field_table_data_address;
    std::uint64_t g_field_frames_data_address;
    std::uint64_t to_table_data_address;
    std::uint64_t to_frames_data_address;
};
static_assert(offsetof(add_wide_parameters, size) == 0);
static_assert(offsetof(add_wide_parameters, f_origin) == 4);
static_assert(offsetof(add_wide_parameters, g_origin) == 8);
static_assert(offsetof(add_wide_parameters, to_origin) == 12);
static_assert(offsetof(add_wide_parameters, f_extent) == 16);
static_assert(offsetof(add_wide_parameters, f_table_extent) == 20);
static_assert(offsetof(add_wide_parameters, f_frames_extent_x) == 24);
static_assert(offsetof(add_wide_parameters, f_frames_extent_y) == 32);
static_assert(offsetof(add_wide_parameters, to_extent) == 36);
static_assert(offsetof(add_wide_parameters, to_table_extent) == 40);
static_assert(offsetof(add_wide_parameters, to_frames_extent_x) == 48);
static_assert(offsetof(add_wide_parameters, to_frames_extent_y) == 56);
static_assert(offsetof(add_wide_parameters, g_field_extent) == 60);
static_assert(offsetof(add_wide_parameters, g_field_table_extent) == 64);
static_assert(offsetof(add_wide_parameters, g_field_frames_extent_y) == 68);
static_assert(offsetof(add_wide_parameters, g_field_frames_extent_x) == 72);
static_assert(offsetof(add_wide_parameters, f_table_data_address) == 80);
static_assert(offsetof(add_wide_parameters, f_frames_data_address) == 88);
static_assert(offsetof(add_wide_parameters, g_field_table_data_address) == 96);
static_assert(offsetof(add_wide_parameters, g_field_frames_data_address) == 104);
static_assert(offsetof(add_wide_parameters, to_table_data_address) == 112);
static_assert(offsetof(add_wide_parameters, to_frames_data_address) == 120);

// shared.glift:38: runs kernel add for the given rows.
GLIFT_HOST_KERNEL
static void add_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const add_wide_parameters*>(call.parameters);
    const uint f_origin = parameters.f_origin;
    const uint g_origin = parameters.g_origin;
    const uint to_origin = parameters.to_origin;
    const uint f_extent = parameters.f_extent;
    const uint f_table_extent = parameters.f_table_extent;
    const std::uint64_t f_frames_extent_x = parameters.f_frames_extent_x;
    const uint f_frames_extent_y = parameters.f_frames_extent_y;
    const uint to_extent = parameters.to_extent;
    const uint to_table_extent = parameters.to_table_extent;
    const std::uint64_t to_frames_extent_x = parameters.to_frames_extent_x;
    const uint to_frames_extent_y = parameters.to_frames_extent_y;
    const uint g_field_extent = parameters.g_field_extent;
    const uint g_field_table_extent = parameters.g_field_table_extent;
    const uint g_field_frames_extent_y = parameters.g_field_frames_extent_y;
    const std::uint64_t g_field_frames_extent_x = parameters.g_field_frames_extent_x;
    const uint* f_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* f_frames_data = glift::host::elements<const float>(call.memories[1]);
    const uint* g_field_table_data = glift::host::elements<const uint>(call.memories[2]);
    const float* g_field_frames_data = glift::host::elements<const float>(call.memories[3]);
    const uint* to_table_data = glift::host::elements<const uint>(call.memories[4]);
    float* to_frames_data = glift::host::elements<float>(call.memories[5]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // shared.glift:39
            const uint f_address = f_origin + address;
            // shared.glift:38
            bool f_either = f_address >= f_extent;
            if (!f_either) {
                const uint f_table_address = f_address / 16u;
                const bool f_table_value_inside = f_table_address < f_table_extent;
                const std::uint64_t f_table_value_at = std::uint64_t(f_table_address);
                const uint f_table_value = f_table_data[f_table_value_inside ? f_table_value_at : std::uint64_t{0u}];
                f_either = (f_table_value_inside ? f_table_value : 0u) == 0u;
            }
            uint2 f_result{};
            bool f_found{};
            if (f_either) {
                f_result = uint2(0u);
                f_found = false;
            } else {
                const uint f_table_address = f_address / 16u;
                const bool f_table_value_inside = f_table_address < f_table_extent;
                const std::uint64_t f_table_value_at = std::uint64_t(f_table_address);
                const uint f_table_value = f_table_data[f_table_value_inside ? f_table_value_at : std::uint64_t{0u}];
                f_result = uint2(f_address % 16u, (f_table_value_inside ? f_table_value : 0u) - 1u);
                f_found = true;
            }
            const uint2 f_place = f_result;
            const std::uint64_t f_at = std::uint64_t(f_place.y) * f_frames_extent_x + std::uint64_t(f_place.x);
            const bool f_found_2 = f_found && f_place.y < f_frames_extent_y;
            // shared.glift:39
            const uint g_address = g_origin + address;
            const uint to_address = to_origin + address;
            // shared.glift:38
            bool to_either = to_address >= to_extent;
            if (!to_either) {
                const uint to_table_address = to_address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const std::uint64_t to_table_value_at = std::uint64_t(to_table_address);
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_value_at
                    : std::uint64_t{0u}];
                to_either = (to_table_value_inside ? to_table_value : 0u) == 0u;
            }
            uint2 to_result{};
            bool to_found{};
            if (to_either) {
                to_result = uint2(0u);
                to_found = false;
            } else {
                const uint to_table_address = to_address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const std::uint64_t to_table_value_at = std::uint64_t(to_table_address);
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_value_at
                    : std::uint64_t{0u}];
                to_result = uint2(to_address % 16u, (to_table_value_inside ? to_table_value : 0u) - 1u);
                to_found = true;
            }
            const uint2 to_place = to_result;
            const std::uint64_t to_at = std::uint64_t(to_place.y) * to_frames_extent_x + std::uint64_t(to_place.x);
            const bool to_found_2 = to_found && to_place.y < to_frames_extent_y;
            // shared.glift:39
            const float f_value = f_frames_data[f_found_2 ? f_at : std::uint64_t{0u}];
            const uint value = g_address + 1u;
            bool g_xp1_field_either = value >= g_field_extent;
            if (!g_xp1_field_either) {
                const uint g_field_table_address = value / 16u;
                const bool g_field_table_value_inside = g_field_table_address < g_field_table_extent;
                const std::uint64_t g_field_table_value_at = std::uint64_t(g_field_table_address);
                const uint g_field_table_value = g_field_table_data[g_field_table_value_inside ? g_field_table_value_at
                    : std::uint64_t{0u}];
                g_xp1_field_either = (g_field_table_value_inside ? g_field_table_value : 0u) == 0u;
            }
            uint2 g_xp1_field_result{};
            bool g_xp1_field_found{};
            if (g_xp1_field_either) {
                g_xp1_field_result = uint2(0u);
                g_xp1_field_found = false;
            } else {
                const uint g_field_table_address = value / 16u;
                const bool g_field_table_value_inside = g_field_table_address < g_field_table_extent;
                const std::uint64_t g_field_table_value_at = std::uint64_t(g_field_table_address);
                const uint g_field_table_value = g_field_table_data[g_field_table_value_inside ? g_field_table_value_at
                    : std::uint64_t{0u}];
                g_xp1_field_result = uint2(value % 16u, (g_field_table_value_inside ? g_field_table_value : 0u) - 1u);
                g_xp1_field_found = true;
            }
            const uint2 g_xp1_field_place = g_xp1_field_result;
            const bool g_xp1_inside = g_xp1_field_found && g_xp1_field_place.y < g_field_frames_extent_y;
            const std::uint64_t g_xp1_at = std::uint64_t(g_xp1_field_place.y) * g_field_frames_extent_x
                + std::uint64_t(g_xp1_field_place.x);
            const float g_xp1 = g_field_frames_data[g_xp1_inside ? g_xp1_at : std::uint64_t{0u}];
            if (to_found_2) {
                to_frames_data[to_at] = (f_found_2 ? f_value : -1.0f) + (g_xp1_inside ? g_xp1 : -1.0f);
            }
        }
    }
}

static void add_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { add_wide_rows(call, rows); });
}

const glift::Binding add_bindings[] = {
    {.name = "f.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 80,
        .element_bytes = sizeof(uint)},
    {.name = "f.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 88,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "g.field.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read,
        .address_offset = 96, .element_bytes = sizeof(uint), .parameter = 1, .radius = 1},
    {.name = "g.field.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read,
        .address_offset = 104, .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::window,
        .radius = 1},
    {.name = "to.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 112,
        .element_bytes = sizeof(uint), .parameter = 2},
    {.name = "to.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 120,
        .element_bytes = sizeof(float), .parameter = 2, .reach = glift::Reach::element},
};
constexpr glift::Parameter add_parameters[] = {
    {"f_extent", 0, sizeof(add_direct_parameters::f_extent)},
    {"f_table_extent", 4, sizeof(add_direct_parameters::f_table_extent)},
    {"f_frames_extent", 8, sizeof(add_direct_parameters::f_frames_extent)},
    {"g_field_extent", 16, sizeof(add_direct_parameters::g_field_extent)},
    {"g_field_table_extent", 20, sizeof(add_direct_parameters::g_field_table_extent)},
    {"g_field_frames_extent", 24, sizeof(add_direct_parameters::g_field_frames_extent)},
};
}  // namespace

extern const glift::Kernel add_kernel;
const glift::Kernel add_kernel = {
    .name = "add",
    .file = "shared.glift",
    .line = 38,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = add_bindings,
    .direct = {.host = &add_direct, .parameter_bytes = 32, .push_constants = true},
    .general = {.host = &add_general, .parameter_bytes = 64},
    .wide = {.host = &add_wide, .parameter_bytes = 128},
    .parameters = add_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// shared.glift:43: move

namespace {
struct move_direct_parameters {
    uint from_extent;
    uint from_table_extent;
    uint2 from_frames_extent;
};
static_assert(offsetof(move_direct_parameters, from_extent) == 0);
static_assert(offsetof(move_direct_parameters, from_table_extent) == 4);
static_assert(offsetof(move_direct_parameters, from_frames_extent) == 8);

// shared.glift:43: runs kernel move for the given rows.
GLIFT_HOST_KERNEL
static void move_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const move_direct_parameters*>(call.parameters);
    const uint from_extent = parameters.from_extent;
    const uint from_table_extent = parameters.from_table_extent;
    const uint2 from_frames_extent = parameters.from_frames_extent;
    const uint* from_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_frames_data = glift::host::elements<const float>(call.memories[1]);
    const uint* to_table_data = glift::host::elements<const uint>(call.memories[2]);
    float* to_frames_data = glift::host::elements<float>(call.memories[3]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // shared.glift:43
            bool to_either = address >= from_extent;
            if (!to_either) {
                const uint to_table_address = address / 16u;
                const bool to_table_value_inside = to_table_address < from_table_extent;
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
                to_either = (to_table_value_inside ? to_table_value : 0u) == 0u;
            }
            uint2 to_result{};
            bool to_found{};
            if (to_either) {
                to_result = uint2(0u);
                to_found = false;
            } else {
                const uint to_table_address = address / 16u;
                const bool to_table_value_inside = to_table_address < from_table_extent;
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
                to_result = uint2(address % 16u, (to_table_value_inside ? to_table_value : 0u) - 1u);
                to_found = true;
            }
            const uint2 to_place = to_result;
            const uint to_at = to_place.y * from_frames_extent.x + to_place.x;
            const bool to_found_2 = to_found && to_place.y < from_frames_extent.y;
            // shared.glift:44
            const uint from_address = address / 2u;
            bool from_either = from_address >= from_extent;
            if (!from_either) {
                const uint from_table_address = from_address / 16u;
                const bool from_table_value_inside = from_table_address < from_table_extent;
                const uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
                from_either = (from_table_value_inside ? from_table_value : 0u) == 0u;
            }
            uint2 from_result{};
            bool from_found{};
            if (from_either) {
                from_result = uint2(0u);
                from_found = false;
            } else {
                const uint from_table_address = from_address / 16u;
                const bool from_table_value_inside = from_table_address < from_table_extent;
                const uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
                from_result = uint2(from_address % 16u, (from_table_value_inside ? from_table_value : 0u) - 1u);
                from_found = true;
            }
            const uint2 from_place = from_result;
            const bool from_value_inside = from_found && from_place.y < from_frames_extent.y;
            const uint from_value_at = from_place.y * from_frames_extent.x + from_place.x;
            const float from_value = from_frames_data[from_value_inside ? from_value_at : 0u];
            if (to_found_2) {
                to_frames_data[to_at] = from_value_inside ? from_value : -1.0f;
            }
        }
    }
}

static void move_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { move_direct_rows(call, rows); });
}

struct move_general_parameters {
    uint size;
    uint a_origin;
    uint from_origin;
    uint to_origin;
    uint to_extent;
    uint to_table_extent;
    uint2 to_frames_extent;
    uint from_extent;
    uint from_table_extent;
    uint2 from_frames_extent;
};
static_assert(offsetof(move_general_parameters, size) == 0);
static_assert(offsetof(move_general_parameters, a_origin) == 4);
static_assert(offsetof(move_general_parameters, from_origin) == 8);
static_assert(offsetof(move_general_parameters, to_origin) == 12);
static_assert(offsetof(move_general_parameters, to_extent) == 16);
static_assert(offsetof(move_general_parameters, to_table_extent) == 20);
static_assert(offsetof(move_general_parameters, to_frames_extent) == 24);
static_assert(offsetof(move_general_parameters, from_extent) == 32);
static_assert(offsetof(move_general_parameters, from_table_extent) == 36);
static_assert(offsetof(move_general_parameters, from_frames_extent) == 40);

// shared.glift:43: runs kernel move for the given rows.
GLIFT_HOST_KERNEL
static void move_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const move_general_parameters*>(call.parameters);
    const uint a_origin = parameters.a_origin;
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint to_extent = parameters.to_extent;
    const uint to_table_extent = parameters.to_table_extent;
    const uint2 to_frames_extent = parameters.to_frames_extent;
    const uint from_extent = parameters.from_extent;
    const uint from_table_extent = parameters.from_table_extent;
    const uint2 from_frames_extent = parameters.from_frames_extent;
    const uint* from_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_frames_data = glift::host::elements<const float>(call.memories[1]);
    const uint* to_table_data = glift::host::elements<const uint>(call.memories[2]);
    float* to_frames_data = glift::host::elements<float>(call.memories[3]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // shared.glift:44
            const uint a_address = a_origin + address;
            const uint to_address = to_origin + address;
            // shared.glift:43
            bool to_either = to_address >= to_extent;
            if (!to_either) {
                const uint to_table_address = to_address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
                to_either = (to_table_value_inside ? to_table_value : 0u) == 0u;
            }
            uint2 to_result{};
            bool to_found{};
            if (to_either) {
                to_result = uint2(0u);
                to_found = false;
            } else {
                const uint to_table_address = to_address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
                to_result = uint2(to_address % 16u, (to_table_value_inside ? to_table_value : 0u) - 1u);
                to_found = true;
            }
            const uint2 to_place = to_result;
            const uint to_at = to_place.y * to_frames_extent.x + to_place.x;
            const bool to_found_2 = to_found && to_place.y < to_frames_extent.y;
            // shared.glift:44
            const uint from_address = a_address / 2u;
            const uint from_virtual = from_origin + from_address;
            bool from_either = from_virtual >= from_extent;
            if (!from_either) {
                const uint from_table_address = from_virtual / 16u;
                const bool from_table_value_inside = from_table_address < from_table_extent;
                const uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
                from_either = (from_table_value_inside ? from_table_value : 0u) == 0u;
            }
            uint2 from_result{};
            bool from_found{};
            if (from_either) {
                from_result = uint2(0u);
                from_found = false;
            } else {
                const uint from_table_address = from_virtual / 16u;
                const bool from_table_value_inside = from_table_address < from_table_extent;
                const uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
                from_result = uint2(from_virtual % 16u, (from_table_value_inside ? from_table_value : 0u) - 1u);
                from_found = true;
            }
            const uint2 from_place = from_result;
            const bool from_value_inside = from_found && from_place.y < from_frames_extent.y;
            const uint from_value_at = from_place.y * from_frames_extent.x + from_place.x;
            const float from_value = from_frames_data[from_value_inside ? from_value_at : 0u];
            if (to_found_2) {
                to_frames_data[to_at] = from_value_inside ? from_value : -1.0f;
            }
        }
    }
}

static void move_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { move_general_rows(call, rows); });
}

struct move_wide_parameters {
    uint size;
    uint a_origin;
    uint from_origin;
    uint to_origin;
    uint to_extent;
    uint to_table_extent;
    std::uint64_t to_frames_extent_x;
    uint to_frames_extent_y;
    uint from_extent;
    uint from_table_extent;
    uint from_frames_extent_y;
    std::uint64_t from_frames_extent_x;
    std::uint64_t from_table_data_address;
    std::uint64_t from_frames_data_address;
    std::uint64_t to_table_data_address;
    std::uint64_t to_frames_data_address;
};
static_assert(offsetof(move_wide_parameters, size) == 0);
static_assert(offsetof(move_wide_parameters, a_origin) == 4);
static_assert(offsetof(move_wide_parameters, from_origin) == 8);
static_assert(offsetof(move_wide_parameters, to_origin) == 12);
static_assert(offsetof(move_wide_parameters, to_extent) == 16);
static_assert(offsetof(move_wide_parameters, to_table_extent) == 20);
static_assert(offsetof(move_wide_parameters, to_frames_extent_x) == 24);
static_assert(offsetof(move_wide_parameters, to_frames_extent_y) == 32);
static_assert(offsetof(move_wide_parameters, from_extent) == 36);
static_assert(offsetof(move_wide_parameters, from_table_extent) == 40);
static_assert(offsetof(move_wide_parameters, from_frames_extent_y) == 44);
static_assert(offsetof(move_wide_parameters, from_frames_extent_x) == 48);
static_assert(offsetof(move_wide_parameters, from_table_data_address) == 56);
static_assert(offsetof(move_wide_parameters, from_frames_data_address) == 64);
static_assert(offsetof(move_wide_parameters, to_table_data_address) == 72);
static_assert(offsetof(move_wide_parameters, to_frames_data_address) == 80);

// shared.glift:43: runs kernel move for the given rows.
GLIFT_HOST_KERNEL
static void move_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const move_wide_parameters*>(call.parameters);
    const uint a_origin = parameters.a_origin;
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint to_extent = parameters.to_extent;
    const uint to_table_extent = parameters.to_table_extent;
    const std::uint64_t to_frames_extent_x = parameters.to_frames_extent_x;
    const uint to_frames_extent_y = parameters.to_frames_extent_y;
    const uint from_extent = parameters.from_extent;
    const uint from_table_extent = parameters.from_table_extent;
    const uint from_frames_extent_y = parameters.from_frames_extent_y;
    const std::uint64_t from_frames_extent_x = parameters.from_frames_extent_x;
    const uint* from_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_frames_data = glift::host::elements<const float>(call.memories[1]);
    const uint* to_table_data = glift::host::elements<const uint>(call.memories[2]);
    float* to_frames_data = glift::host::elements<float>(call.memories[3]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // shared.glift:44
            const uint a_address = a_origin + address;
            const uint to_address = to_origin + address;
            // shared.glift:43
            bool to_either = to_address >= to_extent;
            if (!to_either) {
                const uint to_table_address = to_address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const std::uint64_t to_table_value_at = std::uint64_t(to_table_address);
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_value_at
                    : std::uint64_t{0u}];
                to_either = (to_table_value_inside ? to_table_value : 0u) == 0u;
            }
            uint2 to_result{};
            bool to_found{};
            if (to_either) {
                to_result = uint2(0u);
                to_found = false;
            } else {
                const uint to_table_address = to_address / 16u;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const std::uint64_t to_table_value_at = std::uint64_t(to_table_address);
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_value_at
                    : std::uint64_t{0u}];
                to_result = uint2(to_address % 16u, (to_table_value_inside ? to_table_value : 0u) - 1u);
                to_found = true;
            }
            const uint2 to_place = to_result;
            const std::uint64_t to_at = std::uint64_t(to_place.y) * to_frames_extent_x + std::uint64_t(to_place.x);
            const bool to_found_2 = to_found && to_place.y < to_frames_extent_y;
            // shared.glift:44
            const uint from_address = a_address / 2u;
            const uint from_virtual = from_origin + from_address;
            bool from_either = from_virtual >= from_extent;
            if (!from_either) {
                const uint from_table_address = from_virtual / 16u;
                const bool from_table_value_inside = from_table_address < from_table_extent;
                const std::uint64_t from_table_value_at = std::uint64_t(from_table_address);
                const uint from_table_value = from_table_data[from_table_value_inside ? from_table_value_at
                    : std::uint64_t{0u}];
                from_either = (from_table_value_inside ? from_table_value : 0u) == 0u;
            }
            uint2 from_result{};
            bool from_found{};
            if (from_either) {
                from_result = uint2(0u);
                from_found = false;
            } else {
                const uint from_table_address = from_virtual / 16u;
                const bool from_table_value_inside = from_table_address < from_table_extent;
                const std::uint64_t from_table_value_at = std::uint64_t(from_table_address);
                const uint from_table_value = from_table_data[from_table_value_inside ? from_table_value_at
                    : std::uint64_t{0u}];
                from_result = uint2(from_virtual % 16u, (from_table_value_inside ? from_table_value : 0u) - 1u);
                from_found = true;
            }
            const uint2 from_place = from_result;
            const bool from_value_inside = from_found && from_place.y < from_frames_extent_y;
            const std::uint64_t from_value_at = std::uint64_t(from_place.y) * from_frames_extent_x
                + std::uint64_t(from_place.x);
            const float from_value = from_frames_data[from_value_inside ? from_value_at : std::uint64_t{0u}];
            if (to_found_2) {
                to_frames_data[to_at] = from_value_inside ? from_value : -1.0f;
            }
        }
    }
}

static void move_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { move_wide_rows(call, rows); });
}

const glift::Binding move_bindings[] = {
    {.name = "from.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 56,
        .element_bytes = sizeof(uint), .apart_from = 4u},
    {.name = "from.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 64,
        .element_bytes = sizeof(float), .reach = glift::Reach::range, .apart_from = 4u},
    {.name = "to.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 72,
        .element_bytes = sizeof(uint), .parameter = 2, .apart_from = 1u},
    {.name = "to.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 80,
        .element_bytes = sizeof(float), .parameter = 2, .reach = glift::Reach::element, .apart_from = 1u},
};
constexpr glift::Parameter move_parameters[] = {
    {"from_extent", 0, sizeof(move_direct_parameters::from_extent)},
    {"from_table_extent", 4, sizeof(move_direct_parameters::from_table_extent)},
    {"from_frames_extent", 8, sizeof(move_direct_parameters::from_frames_extent)},
};
}  // namespace

extern const glift::Kernel move_kernel;
const glift::Kernel move_kernel = {
    .name = "move",
    .file = "shared.glift",
    .line = 43,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = move_bindings,
    .direct = {.host = &move_direct, .parameter_bytes = 16, .push_constants = true},
    .general = {.host = &move_general, .parameter_bytes = 48},
    .wide = {.host = &move_wide, .parameter_bytes = 88},
    .parameters = move_parameters,
    .items = {2, 1, 1},
};

}  // namespace shared

