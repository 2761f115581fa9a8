// Made by gliftc from blocks.glift. Changes are lost when it is made again.
#include "blocks.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace blocks {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// blocks.glift:16: Listed.blocks

namespace {
struct blocks_blocks_Listed_2_direct_parameters {
    uint result_extent;
    uint self_state_value_inside;
    glift::Bool self_state_value_inside_2;
    uint self_capacity;
};
static_assert(offsetof(blocks_blocks_Listed_2_direct_parameters, result_extent) == 0);
static_assert(offsetof(blocks_blocks_Listed_2_direct_parameters, self_state_value_inside) == 4);
static_assert(offsetof(blocks_blocks_Listed_2_direct_parameters, self_state_value_inside_2) == 8);
static_assert(offsetof(blocks_blocks_Listed_2_direct_parameters, self_capacity) == 12);

// blocks.glift:16: runs kernel Listed.blocks for the given rows.
GLIFT_HOST_KERNEL
static void blocks_blocks_Listed_2_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const blocks_blocks_Listed_2_direct_parameters*>(call.parameters);
    const uint self_state_value_inside = parameters.self_state_value_inside;
    const bool self_state_value_inside_2 = parameters.self_state_value_inside_2;
    const uint self_capacity = parameters.self_capacity;
    const uint* self_state_data = glift::host::elements<const uint>(call.memories[0]);
    uint* result_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            uint* result_data_row = glift::host::row_pointer(result_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // blocks.glift:16
                const uint self_state_value = self_state_data[self_state_value_inside];
                result_data_row[i] = glift::min(self_state_value_inside_2 ? self_state_value : 0u, self_capacity);
            }
        }
    }
}

static void blocks_blocks_Listed_2_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { blocks_blocks_Listed_2_direct_rows(call,
        rows); });
}

struct blocks_blocks_Listed_2_general_parameters {
    uint size;
    uint result_origin;
    uint self_state_value_inside;
    glift::Bool self_state_value_inside_2;
    uint self_capacity;
};
static_assert(offsetof(blocks_blocks_Listed_2_general_parameters, size) == 0);
static_assert(offsetof(blocks_blocks_Listed_2_general_parameters, result_origin) == 4);
static_assert(offsetof(blocks_blocks_Listed_2_general_parameters, self_state_value_inside) == 8);
static_assert(offsetof(blocks_blocks_Listed_2_general_parameters, self_state_value_inside_2) == 12);
static_assert(offsetof(blocks_blocks_Listed_2_general_parameters, self_capacity) == 16);

// blocks.glift:16: runs kernel Listed.blocks for the given rows.
GLIFT_HOST_KERNEL
static void blocks_blocks_Listed_2_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const blocks_blocks_Listed_2_general_parameters*>(call.parameters);
    const uint result_origin = parameters.result_origin;
    const uint self_state_value_inside = parameters.self_state_value_inside;
    const bool self_state_value_inside_2 = parameters.self_state_value_inside_2;
    const uint self_capacity = parameters.self_capacity;
    const uint* self_state_data = glift::host::elements<const uint>(call.memories[0]);
    uint* result_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // blocks.glift:16
            const uint result_address = result_origin + address;
            uint* result_data_row = glift::host::row_pointer(result_data + result_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // blocks.glift:16
                const uint self_state_value = self_state_data[self_state_value_inside];
                result_data_row[i] = glift::min(self_state_value_inside_2 ? self_state_value : 0u, self_capacity);
            }
        }
    }
}

static void blocks_blocks_Listed_2_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { blocks_blocks_Listed_2_general_rows(call,
        rows); });
}

struct blocks_blocks_Listed_2_wide_parameters {
    uint size;
    uint result_origin;
    std::uint64_t self_state_value_inside;
    glift::Bool self_state_value_inside_2;
    uint self_capacity;
    std::uint64_t self_state_data_address;
    std::uint64_t result_data_address;
};
static_assert(offsetof(blocks_blocks_Listed_2_wide_parameters, size) == 0);
static_assert(offsetof(blocks_blocks_Listed_2_wide_parameters, result_origin) == 4);
static_assert(offsetof(blocks_blocks_Listed_2_wide_parameters, self_state_value_inside) == 8);
static_assert(offsetof(blocks_blocks_Listed_2_wide_parameters, self_state_value_inside_2) == 16);
static_assert(offsetof(blocks_blocks_Listed_2_wide_parameters, self_capacity) == 20);
static_assert(offsetof(blocks_blocks_Listed_2_wide_parameters, self_state_data_address) == 24);
static_assert(offsetof(blocks_blocks_Listed_2_wide_parameters, result_data_address) == 32);

// blocks.glift:16: runs kernel Listed.blocks for the given rows.
GLIFT_HOST_KERNEL
static void blocks_blocks_Listed_2_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const blocks_blocks_Listed_2_wide_parameters*>(call.parameters);
    const uint result_origin = parameters.result_origin;
    const std::uint64_t self_state_value_inside = parameters.self_state_value_inside;
    const bool self_state_value_inside_2 = parameters.self_state_value_inside_2;
    const uint self_capacity = parameters.self_capacity;
    const uint* self_state_data = glift::host::elements<const uint>(call.memories[0]);
    uint* result_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // blocks.glift:16
            const uint result_address = result_origin + address;
            const std::uint64_t result_at = std::uint64_t(result_address);
            const uint self_state_value = self_state_data[self_state_value_inside];
            result_data[result_at] = glift::min(self_state_value_inside_2 ? self_state_value : 0u, self_capacity);
        }
    }
}

static void blocks_blocks_Listed_2_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { blocks_blocks_Listed_2_wide_rows(call,
        rows); });
}

const glift::Binding blocks_blocks_Listed_2_bindings[] = {
    {.name = "self.state.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24,
        .element_bytes = sizeof(uint)},
    {.name = "result.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 32,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter blocks_blocks_Listed_2_parameters[] = {
    {"result_extent", 0, sizeof(blocks_blocks_Listed_2_direct_parameters::result_extent)},
    {"self_state_value_inside", 4, sizeof(blocks_blocks_Listed_2_direct_parameters::self_state_value_inside)},
    {"self_state_value_inside_2", 8, sizeof(blocks_blocks_Listed_2_direct_parameters::self_state_value_inside_2)},
    {"self_capacity", 12, sizeof(blocks_blocks_Listed_2_direct_parameters::self_capacity)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel blocks_blocks_Listed_2_kernel;
const glift::Kernel blocks_blocks_Listed_2_kernel = {
    .name = "blocks",
    .file = "blocks.glift",
    .line = 16,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = blocks_blocks_Listed_2_bindings,
    .direct = {.host = &blocks_blocks_Listed_2_direct, .parameter_bytes = 16, .push_constants = true},
    .general = {.host = &blocks_blocks_Listed_2_general, .parameter_bytes = 20},
    .wide = {.host = &blocks_blocks_Listed_2_wide, .parameter_bytes = 40},
    .parameters = blocks_blocks_Listed_2_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// blocks.glift:21: scale

namespace {
struct scale_direct_parameters {
    uint2 size;
    uint f_active_extent;
    uint div_ceil_x;
    uint div_ceil_y;
    uint div_ceil_y_2;
    uint div_ceil_x_2;
    uint f_table_extent;
    uint2 f_frames_extent;
    uint3 f_extent;
    float by;
};
static_assert(offsetof(scale_direct_parameters, size) == 0);
static_assert(offsetof(scale_direct_parameters, f_active_extent) == 8);
static_assert(offsetof(scale_direct_parameters, div_ceil_x) == 12);
static_assert(offsetof(scale_direct_parameters, div_ceil_y) == 16);
static_assert(offsetof(scale_direct_parameters, div_ceil_y_2) == 20);
static_assert(offsetof(scale_direct_parameters, div_ceil_x_2) == 24);
static_assert(offsetof(scale_direct_parameters, f_table_extent) == 28);
static_assert(offsetof(scale_direct_parameters, f_frames_extent) == 32);
static_assert(offsetof(scale_direct_parameters, f_extent) == 40);
static_assert(offsetof(scale_direct_parameters, by) == 52);

// blocks.glift:21: runs kernel scale for the given rows.
GLIFT_HOST_KERNEL
static void scale_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const scale_direct_parameters*>(call.parameters);
    const uint f_active_extent = parameters.f_active_extent;
    const uint div_ceil_x = parameters.div_ceil_x;
    const uint div_ceil_y = parameters.div_ceil_y;
    const uint div_ceil_y_2 = parameters.div_ceil_y_2;
    const uint div_ceil_x_2 = parameters.div_ceil_x_2;
    const uint f_table_extent = parameters.f_table_extent;
    const uint2 f_frames_extent = parameters.f_frames_extent;
    const uint3 f_extent = parameters.f_extent;
    const float by = parameters.by;
    const uint* g_active_data = glift::host::elements<const uint>(call.memories[0]);
    const uint* f_table_data = glift::host::elements<const uint>(call.memories[1]);
    const float* f_frames_data = glift::host::elements<const float>(call.memories[2]);
    const uint* g_table_data = glift::host::elements<const uint>(call.memories[3]);
    float* g_frames_data = glift::host::elements<float>(call.memories[4]);
    for (const glift::host::Row row : rows) {
        bool is_whole = false;
        {
            const uint2 block_2{row.begin, row.y};
            const bool g_active_value_inside = block_2.y < f_active_extent;
            const uint g_active_value = g_active_data[g_active_value_inside ? block_2.y : 0u];
            const uint rest = g_active_value_inside ? g_active_value : 0u;
            const uint block_x = glift::remainder(rest, div_ceil_x);
            const uint rest_2 = glift::divide(rest, div_ceil_x);
            const uint block_y = glift::remainder(rest_2, div_ceil_y);
            const uint block_z = glift::divide(rest_2, div_ceil_y);
            // blocks.glift:21
            const uint f_table_address = (block_z * div_ceil_y_2 + block_y) * div_ceil_x_2 + block_x;
            const bool f_table_value_inside = f_table_address < f_table_extent;
            const uint value = f_table_value_inside ? f_table_address : 0u;
            const uint f_table_value = f_table_data[value];
            const uint f_entry = f_table_value_inside ? f_table_value : 0u;
            const uint f_frames_index = f_entry - 1u;
            const uint g_table_value = g_table_data[value];
            const uint g_entry = f_table_value_inside ? g_table_value : 0u;
            const uint g_frames_index = g_entry - 1u;
            is_whole = block_x <= 536870911u && block_y <= 536870911u && block_z <= 536870911u
                && glift::all(glift::lessThan(uint3(block_x * 8u + 7u, block_y * 8u + 7u, block_z * 8u + 7u), f_extent))
                && (!(f_entry == 0u) && f_frames_index < f_frames_extent.y
                && (!(g_entry == 0u) && g_frames_index < f_frames_extent.y));
            if (is_whole) {
                if (row.begin < row.end) {
                    const uint2 address{row.begin, row.y};
                    const uint in_block = address.x;
                    // blocks.glift:21
                    const uint f_at = f_frames_index * f_frames_extent.x + in_block;
                    const uint g_at = g_frames_index * f_frames_extent.x + in_block;
                    const float* f_frames_data_row = glift::host::row_pointer(f_frames_data + f_at);
                    float* g_frames_data_row = glift::host::row_pointer(g_frames_data + g_at);
                    GLIFT_INDEPENDENT
                    for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                        // blocks.glift:21
                        g_frames_data_row[i] = by * f_frames_data_row[i];
                    }
                }
            }
        }
        if (!is_whole) {
            GLIFT_INDEPENDENT
            for (uint x = row.begin; x < row.end; ++x) {
                const uint2 address{x, row.y};
                const uint in_block = address.x;
                const bool g_active_value_inside = address.y < f_active_extent;
                const uint g_active_value = g_active_data[g_active_value_inside ? address.y : 0u];
                const uint rest = g_active_value_inside ? g_active_value : 0u;
                const uint block_x = glift::remainder(rest, div_ceil_x);
                const uint rest_2 = glift::divide(rest, div_ceil_x);
                const uint block_y = glift::remainder(rest_2, div_ceil_y);
                const uint block_z = glift::divide(rest_2, div_ceil_y);
                // blocks.glift:21
                const uint f_table_address = (block_z * div_ceil_y_2 + block_y) * div_ceil_x_2 + block_x;
                const bool f_table_value_inside = f_table_address < f_table_extent;
                const uint value = f_table_value_inside ? f_table_address : 0u;
                const uint f_table_value = f_table_data[value];
                const uint f_entry = f_table_value_inside ? f_table_value : 0u;
                const uint f_frames_index = f_entry - 1u;
                const bool f_found = !(f_entry == 0u) && f_frames_index < f_frames_extent.y;
                const uint g_table_value = g_table_data[value];
                const uint g_entry = f_table_value_inside ? g_table_value : 0u;
                const uint g_frames_index = g_entry - 1u;
                const bool g_found = !(g_entry == 0u) && g_frames_index < f_frames_extent.y;
                if (block_x <= 536870911u && block_y <= 536870911u && block_z <= 536870911u
                    && glift::all(glift::lessThan(uint3(block_x * 8u + in_block % 8u, block_y * 8u + in_block / 8u % 8u,
                    block_z * 8u + in_block / 64u), f_extent))) {
                    const uint f_at = f_frames_index * f_frames_extent.x + in_block;
                    const uint g_at = g_frames_index * f_frames_extent.x + in_block;
                    const float f_value = f_frames_data[f_found ? f_at : 0u];
                    if (g_found) {
                        g_frames_data[g_at] = by * (f_found ? f_value : -1.0f);
                    }
                }
            }
        }
    }
}

static void scale_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { scale_direct_rows(call, rows); });
}

struct scale_general_parameters {
    uint2 size;
    uint3 g_origin;
    uint3 f_origin;
    uint3 g_size;
    uint g_active_extent;
    uint div_ceil_x;
    uint div_ceil_y;
    uint div_ceil_y_2;
    uint div_ceil_x_2;
    uint g_table_extent;
    uint2 g_frames_extent;
    uint div_ceil_y_3;
    uint div_ceil_x_3;
    uint f_table_extent;
    uint2 f_frames_extent;
    float by;
};
static_assert(offsetof(scale_general_parameters, size) == 0);
static_assert(offsetof(scale_general_parameters, g_origin) == 8);
static_assert(offsetof(scale_general_parameters, f_origin) == 20);
static_assert(offsetof(scale_general_parameters, g_size) == 32);
static_assert(offsetof(scale_general_parameters, g_active_extent) == 44);
static_assert(offsetof(scale_general_parameters, div_ceil_x) == 48);
static_assert(offsetof(scale_general_parameters, div_ceil_y) == 52);
static_assert(offsetof(scale_general_parameters, div_ceil_y_2) == 56);
static_assert(offsetof(scale_general_parameters, div_ceil_x_2) == 60);
static_assert(offsetof(scale_general_parameters, g_table_extent) == 64);
static_assert(offsetof(scale_general_parameters, g_frames_extent) == 68);
static_assert(offsetof(scale_general_parameters, div_ceil_y_3) == 76);
static_assert(offsetof(scale_general_parameters, div_ceil_x_3) == 80);
static_assert(offsetof(scale_general_parameters, f_table_extent) == 84);
static_assert(offsetof(scale_general_parameters, f_frames_extent) == 88);
static_assert(offsetof(scale_general_parameters, by) == 96);

// blocks.glift:21: runs kernel scale for the given rows.
GLIFT_HOST_KERNEL
static void scale_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const scale_general_parameters*>(call.parameters);
    const uint3 g_origin = parameters.g_origin;
    const uint3 f_origin = parameters.f_origin;
    const uint3 g_size = parameters.g_size;
    const uint g_active_extent = parameters.g_active_extent;
    const uint div_ceil_x = parameters.div_ceil_x;
    const uint div_ceil_y = parameters.div_ceil_y;
    const uint div_ceil_y_2 = parameters.div_ceil_y_2;
    const uint div_ceil_x_2 = parameters.div_ceil_x_2;
    const uint g_table_extent = parameters.g_table_extent;
    const uint2 g_frames_extent = parameters.g_frames_extent;
    const uint div_ceil_y_3 = parameters.div_ceil_y_3;
    const uint div_ceil_x_3 = parameters.div_ceil_x_3;
    const uint f_table_extent = parameters.f_table_extent;
    const uint2 f_frames_extent = parameters.f_frames_extent;
    const float by = parameters.by;
    const uint* g_active_data = glift::host::elements<const uint>(call.memories[0]);
    const uint* f_table_data = glift::host::elements<const uint>(call.memories[1]);
    const float* f_frames_data = glift::host::elements<const float>(call.memories[2]);
    const uint* g_table_data = glift::host::elements<const uint>(call.memories[3]);
    float* g_frames_data = glift::host::elements<float>(call.memories[4]);
    for (const glift::host::Row row : rows) {
        bool is_whole = false;
        {
            const uint2 block_2{row.begin, row.y};
            const bool g_active_value_inside = block_2.y < g_active_extent;
            const uint g_active_value = g_active_data[g_active_value_inside ? block_2.y : 0u];
            const uint rest = g_active_value_inside ? g_active_value : 0u;
            const uint block_x = glift::remainder(rest, div_ceil_x);
            const uint rest_2 = glift::divide(rest, div_ceil_x);
            const uint block_y = glift::remainder(rest_2, div_ceil_y);
            const uint block_z = glift::divide(rest_2, div_ceil_y);
            // blocks.glift:21
            const uint value = block_z * 8u;
            const uint value_2 = block_y * 8u;
            const uint value_3 = block_x * 8u;
            const uint g_table_address = (block_z * div_ceil_y_2 + block_y) * div_ceil_x_2 + block_x;
            const bool g_table_value_inside = g_table_address < g_table_extent;
            const uint g_table_value = g_table_data[g_table_value_inside ? g_table_address : 0u];
            const uint g_entry = g_table_value_inside ? g_table_value : 0u;
            const uint g_frames_index = g_entry - 1u;
            const uint3 value_4 = uint3(value_3 + 7u, value_2 + 7u, value + 7u) - g_origin;
            is_whole = block_x <= 536870911u && block_y <= 536870911u && block_z <= 536870911u
                && (glift::all(glift::lessThan(value_4 - uint3(7u, 7u, 7u), g_size))
                && glift::all(glift::lessThan(value_4, g_size)))
                && (!(g_entry == 0u) && g_frames_index < g_frames_extent.y);
            if (is_whole) {
                if (row.begin < row.end) {
                    const uint2 address{row.begin, row.y};
                    const uint in_block = address.x;
                    // blocks.glift:21
                    const uint g_at = g_frames_index * g_frames_extent.x + in_block;
                    float* g_frames_data_row = glift::host::row_pointer(g_frames_data + g_at);
                    GLIFT_INDEPENDENT
                    for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                        const uint2 address{row.begin + static_cast<uint>(i), row.y};
                        const uint in_block_2 = address.x;
                        // blocks.glift:21
                        const uint value_5 = value + in_block_2 / 64u + (f_origin.z - g_origin.z);
                        const uint value_6 = value_2 + in_block_2 / 8u % 8u + (f_origin.y - g_origin.y);
                        const uint value_7 = value_3 + in_block_2 % 8u + (f_origin.x - g_origin.x);
                        const uint f_table_address = (value_5 / 8u * div_ceil_y_3 + value_6 / 8u) * div_ceil_x_3
                            + value_7 / 8u;
                        const bool f_table_value_inside = f_table_address < f_table_extent;
                        const uint f_table_value = f_table_data[f_table_value_inside ? f_table_address : 0u];
                        const uint f_entry = f_table_value_inside ? f_table_value : 0u;
                        const uint f_frames_index = f_entry - 1u;
                        const uint f_at = f_frames_index * f_frames_extent.x
                            + ((value_5 % 8u * 8u + value_6 % 8u) * 8u + value_7 % 8u);
                        const bool f_found = !(f_entry == 0u) && f_frames_index < f_frames_extent.y;
                        const float f_value = f_frames_data[f_found ? f_at : 0u];
                        g_frames_data_row[i] = by * (f_found ? f_value : -1.0f);
                    }
                }
            }
        }
        if (!is_whole) {
            GLIFT_INDEPENDENT
            for (uint x = row.begin; x < row.end; ++x) {
                const uint2 address{x, row.y};
                const uint in_block = address.x;
                const bool g_active_value_inside = address.y < g_active_extent;
                const uint g_active_value = g_active_data[g_active_value_inside ? address.y : 0u];
                const uint rest = g_active_value_inside ? g_active_value : 0u;
                const uint block_x = glift::remainder(rest, div_ceil_x);
                const uint rest_2 = glift::divide(rest, div_ceil_x);
                const uint block_y = glift::remainder(rest_2, div_ceil_y);
                const uint block_z = glift::divide(rest_2, div_ceil_y);
                // blocks.glift:21
                const uint g_table_address = (block_z * div_ceil_y_2 + block_y) * div_ceil_x_2 + block_x;
                const bool g_table_value_inside = g_table_address < g_table_extent;
                const uint g_table_value = g_table_data[g_table_value_inside ? g_table_address : 0u];
                const uint g_entry = g_table_value_inside ? g_table_value : 0u;
                const uint g_frames_index = g_entry - 1u;
                const bool g_found = !(g_entry == 0u) && g_frames_index < g_frames_extent.y;
                const uint value = block_x * 8u + in_block % 8u;
                const uint value_2 = block_y * 8u + in_block / 8u % 8u;
                const uint value_3 = block_z * 8u + in_block / 64u;
                if (block_x <= 536870911u && block_y <= 536870911u && block_z <= 536870911u
                    && glift::all(glift::lessThan(uint3(value, value_2, value_3) - g_origin, g_size))) {
                    const uint value_4 = value_3 + (f_origin.z + g_origin.z * 4294967295u);
                    const uint value_5 = value_2 + (f_origin.y + g_origin.y * 4294967295u);
                    const uint value_6 = value + (f_origin.x + g_origin.x * 4294967295u);
                    const uint f_table_address = (value_4 / 8u * div_ceil_y_3 + value_5 / 8u) * div_ceil_x_3
                        + value_6 / 8u;
                    const bool f_table_value_inside = f_table_address < f_table_extent;
                    const uint f_table_value = f_table_data[f_table_value_inside ? f_table_address : 0u];
                    const uint f_entry = f_table_value_inside ? f_table_value : 0u;
                    const uint f_frames_index = f_entry - 1u;
                    const uint f_at = f_frames_index * f_frames_extent.x
                        + ((value_4 % 8u * 8u + value_5 % 8u) * 8u + value_6 % 8u);
                    const bool f_found = !(f_entry == 0u) && f_frames_index < f_frames_extent.y;
                    const uint g_at = g_frames_index * g_frames_extent.x + in_block;
                    const float f_value = f_frames_data[f_found ? f_at : 0u];
                    if (g_found) {
                        g_frames_data[g_at] = by * (f_found ? f_value : -1.0f);
                    }
                }
            }
        }
    }
}

static void scale_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { scale_general_rows(call, rows); });
}

struct scale_wide_parameters {
    uint2 size;
    uint3 g_origin;
    uint3 f_origin;
    uint3 g_size;
    uint g_active_extent;
    uint div_ceil_x;
    uint div_ceil_y;
    uint div_ceil_y_2;
    uint div_ceil_x_2;
    uint g_table_extent;
    uint g_frames_extent_y;
    uint div_ceil_y_3;
    uint div_ceil_x_3;
    uint f_table_extent;
    std::uint64_t f_frames_extent_x;
    uint f_frames_extent_y;
    std::uint64_t g_frames_extent_x;
    float by;
    std::uint64_t g_active_data_address;
    std::uint64_t f_table_data_address;
    std::uint64_t f_frames_data_address;
    std::uint64_t g_table_data_address;
    std::uint64_t g_frames_data_address;
};
static_assert(offsetof(scale_wide_parameters, size) == 0);
static_assert(offsetof(scale_wide_parameters, g_origin) == 8);
static_assert(offsetof(scale_wide_parameters, f_origin) == 20);
static_assert(offsetof(scale_wide_parameters, g_size) == 32);
static_assert(offsetof(scale_wide_parameters, g_active_extent) == 44);
static_assert(offsetof(scale_wide_parameters, div_ceil_x) == 48);
static_assert(offsetof(scale_wide_parameters, div_ceil_y) == 52);
static_assert(offsetof(scale_wide_parameters, div_ceil_y_2) == 56);
static_assert(offsetof(scale_wide_parameters, div_ceil_x_2) == 60);
static_assert(offsetof(scale_wide_parameters, g_table_extent) == 64);
static_assert(offsetof(scale_wide_parameters, g_frames_extent_y) == 68);
static_assert(offsetof(scale_wide_parameters, div_ceil_y_3) == 72);
static_assert(offsetof(scale_wide_parameters, div_ceil_x_3) == 76);
static_assert(offsetof(scale_wide_parameters, f_table_extent) == 80);
static_assert(offsetof(scale_wide_parameters, f_frames_extent_x) == 88);
static_assert(offsetof(scale_wide_parameters, f_frames_extent_y) == 96);
static_assert(offsetof(scale_wide_parameters, g_frames_extent_x) == 104);
static_assert(offsetof(scale_wide_parameters, by) == 112);
static_assert(offsetof(scale_wide_parameters, g_active_data_address) == 120);
static_assert(offsetof(scale_wide_parameters, f_table_data_address) == 128);
static_assert(offsetof(scale_wide_parameters, f_frames_data_address) == 136);
static_assert(offsetof(scale_wide_parameters, g_table_data_address) == 144);
static_assert(offsetof(scale_wide_parameters, g_frames_data_address) == 152);

// blocks.glift:21: runs kernel scale for the given rows.
GLIFT_HOST_KERNEL
static void scale_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const scale_wide_parameters*>(call.parameters);
    const uint3 g_origin = parameters.g_origin;
    const uint3 f_origin = parameters.f_origin;
    const uint3 g_size = parameters.g_size;
    const uint g_active_extent = parameters.g_active_extent;
    const uint div_ceil_x = parameters.div_ceil_x;
    const uint div_ceil_y = parameters.div_ceil_y;
    const uint div_ceil_y_2 = parameters.div_ceil_y_2;
    const uint div_ceil_x_2 = parameters.div_ceil_x_2;
    const uint g_table_extent = parameters.g_table_extent;
    const uint g_frames_extent_y = parameters.g_frames_extent_y;
    const uint div_ceil_y_3 = parameters.div_ceil_y_3;
    const uint div_ceil_x_3 = parameters.div_ceil_x_3;
    const uint f_table_extent = parameters.f_table_extent;
    const std::uint64_t f_frames_extent_x = parameters.f_frames_extent_x;
    const uint f_frames_extent_y = parameters.f_frames_extent_y;
    const std::uint64_t g_frames_extent_x = parameters.g_frames_extent_x;
    const float by = parameters.by;
    const uint* g_active_data = glift::host::elements<const uint>(call.memories[0]);
    const uint* f_table_data = glift::host::elements<const uint>(call.memories[1]);
    const float* f_frames_data = glift::host::elements<const float>(call.memories[2]);
    const uint* g_table_data = glift::host::elements<const uint>(call.memories[3]);
    float* g_frames_data = glift::host::elements<float>(call.memories[4]);
    for (const glift::host::Row row : rows) {
        bool is_whole = false;
        {
            const uint2 block_2{row.begin, row.y};
            const bool g_active_value_inside = block_2.y < g_active_extent;
            const std::uint64_t g_active_value_at = std::uint64_t(block_2.y);
            const uint g_active_value = g_active_data[g_active_value_inside ? g_active_value_at : std::uint64_t{0u}];
            const uint rest = g_active_value_inside ? g_active_value : 0u;
            const uint block_x = glift::remainder(rest, div_ceil_x);
            const uint rest_2 = glift::divide(rest, div_ceil_x);
            const uint block_y = glift::remainder(rest_2, div_ceil_y);
            const uint block_z = glift::divide(rest_2, div_ceil_y);
            // blocks.glift:21
            const uint value = block_z * 8u;
            const uint value_2 = block_y * 8u;
            const uint value_3 = block_x * 8u;
            const uint g_table_address = (block_z * div_ceil_y_2 + block_y) * div_ceil_x_2 + block_x;
            const bool g_table_value_inside = g_table_address < g_table_extent;
            const std::uint64_t g_table_value_at = std::uint64_t(g_table_address);
            const uint g_table_value = g_table_data[g_table_value_inside ? g_table_value_at : std::uint64_t{0u}];
            const uint g_entry = g_table_value_inside ? g_table_value : 0u;
            const uint value_4 = g_entry - 1u;
            const uint3 value_5 = uint3(value_3 + 7u, value_2 + 7u, value + 7u) - g_origin;
            is_whole = block_x <= 536870911u && block_y <= 536870911u && block_z <= 536870911u
                && (glift::all(glift::lessThan(value_5 - uint3(7u, 7u, 7u), g_size))
                && glift::all(glift::lessThan(value_5, g_size))) && (!(g_entry == 0u) && value_4 < g_frames_extent_y);
            if (is_whole) {
                GLIFT_INDEPENDENT
                for (uint x = row.begin; x < row.end; ++x) {
                    const uint2 address{x, row.y};
                    const uint in_block = address.x;
                    // blocks.glift:21
                    const uint value_6 = value + in_block / 64u + (f_origin.z - g_origin.z);
                    const uint value_7 = value_2 + in_block / 8u % 8u + (f_origin.y - g_origin.y);
                    const uint value_8 = value_3 + in_block % 8u + (f_origin.x - g_origin.x);
                    const uint f_table_address = (value_6 / 8u * div_ceil_y_3 + value_7 / 8u) * div_ceil_x_3
                        + value_8 / 8u;
                    const bool f_table_value_inside = f_table_address < f_table_extent;
                    const std::uint64_t f_table_value_at = std::uint64_t(f_table_address);
                    const uint f_table_value = f_table_data[f_table_value_inside ? f_table_value_at
                        : std::uint64_t{0u}];
                    const uint f_entry = f_table_value_inside ? f_table_value : 0u;
                    const uint value_9 = f_entry - 1u;
                    const std::uint64_t f_at = std::uint64_t(value_9) * f_frames_extent_x
                        + std::uint64_t((value_6 % 8u * 8u + value_7 % 8u) * 8u + value_8 % 8u);
                    const bool f_found = !(f_entry == 0u) && value_9 < f_frames_extent_y;
                    const std::uint64_t g_at = std::uint64_t(value_4) * g_frames_extent_x + std::uint64_t(in_block);
                    const float f_value = f_frames_data[f_found ? f_at : std::uint64_t{0u}];
                    g_frames_data[g_at] = by * (f_found ? f_value : -1.0f);
                }
            }
        }
        if (!is_whole) {
            GLIFT_INDEPENDENT
            for (uint x = row.begin; x < row.end; ++x) {
                const uint2 address{x, row.y};
                const uint in_block = address.x;
                const bool g_active_value_inside = address.y < g_active_extent;
                const std::uint64_t g_active_value_at = std::uint64_t(address.y);
                const uint g_active_value = g_active_data[g_active_value_inside ? g_active_value_at
                    : std::uint64_t{0u}];
                const uint rest = g_active_value_inside ? g_active_value : 0u;
                const uint block_x = glift::remainder(rest, div_ceil_x);
                const uint rest_2 = glift::divide(rest, div_ceil_x);
                const uint block_y = glift::remainder(rest_2, div_ceil_y);
                const uint block_z = glift::divide(rest_2, div_ceil_y);
                // blocks.glift:21
                const uint g_table_address = (block_z * div_ceil_y_2 + block_y) * div_ceil_x_2 + block_x;
                const bool g_table_value_inside = g_table_address < g_table_extent;
                const std::uint64_t g_table_value_at = std::uint64_t(g_table_address);
                const uint g_table_value = g_table_data[g_table_value_inside ? g_table_value_at : std::uint64_t{0u}];
                const uint g_entry = g_table_value_inside ? g_table_value : 0u;
                const uint value = g_entry - 1u;
                const bool g_found = !(g_entry == 0u) && value < g_frames_extent_y;
                const uint value_2 = block_x * 8u + in_block % 8u;
                const uint value_3 = block_y * 8u + in_block / 8u % 8u;
                const uint value_4 = block_z * 8u + in_block / 64u;
                if (block_x <= 536870911u && block_y <= 536870911u && block_z <= 536870911u
                    && glift::all(glift::lessThan(uint3(value_2, value_3, value_4) - g_origin, g_size))) {
                    const uint value_5 = value_4 + (f_origin.z + g_origin.z * 4294967295u);
                    const uint value_6 = value_3 + (f_origin.y + g_origin.y * 4294967295u);
                    const uint value_7 = value_2 + (f_origin.x + g_origin.x * 4294967295u);
                    const uint f_table_address = (value_5 / 8u * div_ceil_y_3 + value_6 / 8u) * div_ceil_x_3
                        + value_7 / 8u;
                    const bool f_table_value_inside = f_table_address < f_table_extent;
                    const std::uint64_t f_table_value_at = std::uint64_t(f_table_address);
                    const uint f_table_value = f_table_data[f_table_value_inside ? f_table_value_at
                        : std::uint64_t{0u}];
                    const uint f_entry = f_table_value_inside ? f_table_value : 0u;
                    const uint value_8 = f_entry - 1u;
                    const std::uint64_t f_at = std::uint64_t(value_8) * f_frames_extent_x
                        + std::uint64_t((value_5 % 8u * 8u + value_6 % 8u) * 8u + value_7 % 8u);
                    const bool f_found = !(f_entry == 0u) && value_8 < f_frames_extent_y;
                    const std::uint64_t g_at = std::uint64_t(value) * g_frames_extent_x + std::uint64_t(in_block);
                    const float f_value = f_frames_data[f_found ? f_at : std::uint64_t{0u}];
                    if (g_found) {
                        g_frames_data[g_at] = by * (f_found ? f_value : -1.0f);
                    }
                }
            }
        }
    }
}

static void scale_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { scale_wide_rows(call, rows); });
}

const glift::Binding scale_bindings[] = {
    {.name = "g.active.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 120,
        .element_bytes = sizeof(uint), .parameter = 1},
    {.name = "f.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 128,
        .element_bytes = sizeof(uint)},
    {.name = "f.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 136,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "g.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 144,
        .element_bytes = sizeof(uint), .parameter = 1},
    {.name = "g.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 152,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter scale_parameters[] = {
    {"size", 0, sizeof(scale_direct_parameters::size)},
    {"f_active_extent", 8, sizeof(scale_direct_parameters::f_active_extent)},
    {"div_ceil_x", 12, sizeof(scale_direct_parameters::div_ceil_x)},
    {"div_ceil_y", 16, sizeof(scale_direct_parameters::div_ceil_y)},
    {"div_ceil_y_2", 20, sizeof(scale_direct_parameters::div_ceil_y_2)},
    {"div_ceil_x_2", 24, sizeof(scale_direct_parameters::div_ceil_x_2)},
    {"f_table_extent", 28, sizeof(scale_direct_parameters::f_table_extent)},
    {"f_frames_extent", 32, sizeof(scale_direct_parameters::f_frames_extent)},
    {"f_extent", 40, sizeof(scale_direct_parameters::f_extent)},
    {"by", 52, sizeof(scale_direct_parameters::by)},
};
}  // namespace

extern const glift::Kernel scale_kernel;
const glift::Kernel scale_kernel = {
    .name = "scale",
    .file = "blocks.glift",
    .line = 21,
    .rank = 2,
    .group = {64, 1, 1},
    .loop_rounds = 9,
    .bindings = scale_bindings,
    .direct = {.host = &scale_direct, .parameter_bytes = 56},
    .general = {.host = &scale_general, .parameter_bytes = 100},
    .wide = {.host = &scale_wide, .parameter_bytes = 160},
    .parameters = scale_parameters,
    .items = {8, 1, 1},
    .of_blocks = true,
    .longest_loop = {"blocks.glift", 21},
};

}  // namespace blocks

