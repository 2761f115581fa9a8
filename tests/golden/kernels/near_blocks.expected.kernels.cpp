// Made by gliftc from near_blocks.glift. Changes are lost when it is made again.
#include "near_blocks.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace near_blocks {

using namespace glift::types;

// near_blocks.glift:20: right

namespace {
struct right_general_parameters {
    uint2 size;
    uint2 g_origin;
    uint2 f_origin;
    uint2 g_size;
    uint g_active_extent;
    uint div_ceil_x;
    uint div_ceil_x_2;
    uint g_table_extent;
    uint2 g_frames_extent;
    uint div_ceil_x_3;
    uint f_table_extent;
    uint2 f_frames_extent;
    uint2 f_extent;
    std::uint64_t g_active_data_address;
    std::uint64_t f_table_data_address;
    std::uint64_t f_frames_data_address;
    std::uint64_t g_table_data_address;
    std::uint64_t g_frames_data_address;
};
static_assert(sizeof(right_general_parameters) == 120);

GLIFT_HOST_KERNEL
static void right_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const right_general_parameters*>(call.parameters);
    const uint2 g_origin = parameters.g_origin;
    const uint2 f_origin = parameters.f_origin;
    const uint2 g_size = parameters.g_size;
    const uint g_active_extent = parameters.g_active_extent;
    const uint div_ceil_x = parameters.div_ceil_x;
    const uint div_ceil_x_2 = parameters.div_ceil_x_2;
    const uint g_table_extent = parameters.g_table_extent;
    const uint2 g_frames_extent = parameters.g_frames_extent;
    const uint div_ceil_x_3 = parameters.div_ceil_x_3;
    const uint f_table_extent = parameters.f_table_extent;
    const uint2 f_frames_extent = parameters.f_frames_extent;
    const uint2 f_extent = parameters.f_extent;
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
            const uint block_y = glift::divide(rest, div_ceil_x);
            // near_blocks.glift:20
            const uint g_table_address = block_y * div_ceil_x_2 + block_x;
            const bool g_table_value_inside = g_table_address < g_table_extent;
            const uint g_table_value = g_table_data[g_table_value_inside ? g_table_address : 0u];
            const uint g_entry = g_table_value_inside ? g_table_value : 0u;
            const uint g_frames_index = g_entry - 1u;
            const uint value = block_x * 8u + 7u;
            const uint2 value_2 = uint2(value, block_y * 8u + 7u) - g_origin;
            is_whole = block_x <= 536870911u && block_y <= 536870911u
                && (glift::all(glift::lessThan(value_2 - uint2(7u, 7u), g_size))
                && glift::all(glift::lessThan(value_2, g_size)))
                && (!(g_entry == 0u) && g_frames_index < g_frames_extent.y && f_origin.x == g_origin.x
                && f_origin.y == g_origin.y);
            if (is_whole) {
                glift::host::Scratch<float, 80> f_around;
                const uint block_x_after_room = f_extent.x - (value + 1u);
                const bool block_x_after_exists = block_x_after_room > 0u && block_x < 536870911u;
                const uint f_table_address = block_y * div_ceil_x_3 + block_x;
                const bool f_table_value_inside = f_table_address < f_table_extent;
                const uint f_table_value = f_table_data[f_table_value_inside ? f_table_address : 0u];
                const uint f_entry = f_table_value_inside ? f_table_value : 0u;
                const uint f_frames_index = f_entry - 1u;
                const bool f_found = !(f_entry == 0u) && f_frames_index < f_frames_extent.y;
                const uint f_table_address_2 = f_table_address + (block_x_after_exists ? 1u : 0u);
                const bool f_table_value_inside_2 = f_table_address_2 < f_table_extent;
                const uint f_table_value_2 = f_table_data[f_table_value_inside_2 ? f_table_address_2 : 0u];
                const uint f_xp_entry = f_table_value_inside_2 ? f_table_value_2 : 0u;
                const uint f_xp_frames_index = f_xp_entry - 1u;
                const bool f_xp_found = block_x_after_exists
                    && (!(f_xp_entry == 0u) && f_xp_frames_index < f_frames_extent.y);
                {
                    if (!(f_found && block_x_after_room >= 2u && f_xp_found)) {
                        for (uint i_2 = 0u; i_2 < 80u; ++i_2) {
                            f_around[i_2] = 0.0f;
                        }
                    }
                    if (f_found) {
                        for (uint y = 0u; y < 8u; ++y) {
                            glift::host::copy_row<8>(f_frames_data + (f_frames_index * f_frames_extent.x + y * 8u),
                                f_around.values + (y * 10u));
                        }
                    }
                    if (f_xp_found) {
                        for (uint y = 0u; y < 8u; ++y) {
                            for (uint x_2 = 0u, x_2_end = glift::min(2u, block_x_after_room); x_2 < x_2_end; ++x_2) {
                                f_around[x_2 + 8u + y * 10u] = f_frames_data[f_xp_frames_index * f_frames_extent.x
                                    + (y * 8u + x_2)];
                            }
                        }
                    }
                }
                for (uint first_2 = row.begin; first_2 < row.end; first_2 += 8u) {
                    if (first_2 < first_2 + 8u) {
                        const uint2 address{first_2, row.y};
                        const uint in_block = address.x;
                        // near_blocks.glift:21
                        const uint f_around_at = in_block % 8u + in_block / 8u * 10u;
                        // near_blocks.glift:20
                        const uint g_at = g_frames_index * g_frames_extent.x + in_block;
                        float* f_around_row = glift::host::row_pointer(f_around.values + (f_around_at + 2u));
                        float* f_around_row_2 = glift::host::row_pointer(f_around.values + f_around_at);
                        float* g_frames_data_row = glift::host::row_pointer(g_frames_data + g_at);
                        GLIFT_BLOCK
                        for (std::size_t i = 0, count = first_2 + 8u - first_2; i < count; ++i) {
                            // near_blocks.glift:21
                            const float first_3 = f_around_row[i];
                            // near_blocks.glift:22
                            g_frames_data_row[i] = first_3 - f_around_row_2[i];
                        }
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
                const uint block_y = glift::divide(rest, div_ceil_x);
                // near_blocks.glift:20
                const uint g_table_address = block_y * div_ceil_x_2 + block_x;
                const bool g_table_value_inside = g_table_address < g_table_extent;
                const uint g_table_value = g_table_data[g_table_value_inside ? g_table_address : 0u];
                const uint g_entry = g_table_value_inside ? g_table_value : 0u;
                const uint g_frames_index = g_entry - 1u;
                const bool g_found = !(g_entry == 0u) && g_frames_index < g_frames_extent.y;
                const uint value = block_x * 8u + in_block % 8u;
                const uint value_2 = block_y * 8u + in_block / 8u;
                const uint2 value_3 = uint2(value, value_2);
                if (block_x <= 536870911u && block_y <= 536870911u
                    && glift::all(glift::lessThan(value_3 - g_origin, g_size))) {
                    const uint value_4 = value_2 + (f_origin.y + g_origin.y * 4294967295u);
                    const uint value_5 = value_4 / 8u * div_ceil_x_3;
                    const uint value_6 = value + (f_origin.x + g_origin.x * 4294967295u);
                    const uint f_table_address = value_5 + value_6 / 8u;
                    const bool f_table_value_inside = f_table_address < f_table_extent;
                    const uint f_table_value = f_table_data[f_table_value_inside ? f_table_address : 0u];
                    const uint f_entry = f_table_value_inside ? f_table_value : 0u;
                    const uint f_frames_index = f_entry - 1u;
                    const uint value_7 = value_4 % 8u * 8u;
                    const uint f_at = f_frames_index * f_frames_extent.x + (value_7 + value_6 % 8u);
                    const bool f_found = !(f_entry == 0u) && f_frames_index < f_frames_extent.y;
                    const uint g_at = g_frames_index * g_frames_extent.x + in_block;
                    // near_blocks.glift:21
                    uint2 f_xp2_result{};
                    bool f_xp2_found{};
                    if (!glift::all(glift::lessThan(value_3 + (f_origin - g_origin) + uint2(2u, 0u), f_extent))) {
                        f_xp2_result = uint2(0u);
                        f_xp2_found = false;
                    } else {
                        const uint value_8 = value_6 + 2u;
                        const uint f_table_address_2 = value_5 + value_8 / 8u;
                        const bool f_table_value_inside_2 = f_table_address_2 < f_table_extent;
                        const uint f_table_value_2 = f_table_data[f_table_value_inside_2 ? f_table_address_2 : 0u];
                        const uint f_xp2_entry = f_table_value_inside_2 ? f_table_value_2 : 0u;
                        f_xp2_result = uint2(value_7 + value_8 % 8u, f_xp2_entry - 1u);
                        f_xp2_found = !(f_xp2_entry == 0u);
                    }
                    const bool f_xp2_inside = f_xp2_found && f_xp2_result.y < f_frames_extent.y;
                    const uint f_xp2_at = f_xp2_result.y * f_frames_extent.x + f_xp2_result.x;
                    const float f_xp2 = f_frames_data[f_xp2_inside ? f_xp2_at : 0u];
                    // near_blocks.glift:22
                    const float f_value = f_frames_data[f_found ? f_at : 0u];
                    if (g_found) {
                        g_frames_data[g_at] = (f_xp2_inside ? f_xp2 : 0.0f) - (f_found ? f_value : 0.0f);
                    }
                }
            }
        }
    }
}

static void right_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { right_general_rows(call, rows); });
}

const glift::Binding right_bindings[] = {
    {.name = "g.active.data", .address_offset = 80, .element_bytes = sizeof(uint), .parameter = 1},
    {.name = "f.table.data", .address_offset = 88, .element_bytes = sizeof(uint), .radius = 2},
    {.name = "f.frames.data", .address_offset = 96, .element_bytes = sizeof(float), .reach = glift::Reach::window,
        .radius = 2},
    {.name = "g.table.data", .address_offset = 104, .element_bytes = sizeof(uint), .parameter = 1},
    {.name = "g.frames.data", .access = glift::Access::write, .address_offset = 112, .element_bytes = sizeof(float),
        .parameter = 1, .reach = glift::Reach::element, .update = glift::Update::assign, .number = glift::Number::real},
};
constexpr glift::Parameter right_parameters[] = {{"size", 0, 8}, {"f_active_extent", 8, 4}, {"div_ceil_x", 12, 4},
    {"div_ceil_x_2", 16, 4}, {"f_table_extent", 20, 4}, {"f_frames_extent", 24, 8}, {"f_extent", 32, 8}};
}  // namespace

extern const glift::Kernel right_kernel;
const glift::Kernel right_kernel = {
    .name = "right",
    .file = "near_blocks.glift",
    .line = 20,
    .rank = 2,
    .group = {64, 1, 1},
    .loop_rounds = 0,
    .bindings = right_bindings,
    .direct = {.parameter_bytes = 40, .uniform_buffer = true},
    .general = {.host = &right_general, .parameter_bytes = 120, .uniform_buffer = true},
    .parameters = right_parameters,
    .of_blocks = true,
};

}  // namespace near_blocks

