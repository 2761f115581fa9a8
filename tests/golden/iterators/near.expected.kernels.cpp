// Made by gliftc from near.glift. Changes are lost when it is made again.
#include "near.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace near_ {

using namespace glift::types;

// near.glift:9: smooth

namespace {
struct smooth_general_parameters {
    uint3 size;
    uint3 f_origin;
    uint3 g_origin;
    uint3 base;
    uint3 f_extent;
    uint3 g_extent;
    std::uint64_t f_data_address;
    std::uint64_t g_data_address;
};
static_assert(sizeof(smooth_general_parameters) == 88);

GLIFT_HOST_KERNEL
static void smooth_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const smooth_general_parameters*>(call.parameters);
    const uint3 f_origin = parameters.f_origin;
    const uint3 g_origin = parameters.g_origin;
    const uint3 f_extent = parameters.f_extent;
    const uint3 g_extent = parameters.g_extent;
    const float* f_data = glift::host::elements<const float>(call.memories[0]);
    float* g_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        const glift::host::Part interior = glift::host::in_blocks(glift::host::interior_of(row, f_origin, f_extent, 1),
            row.end);
        for (const glift::host::Section& part : glift::host::sections(row.begin, interior, row.end)) {
            if (part.is_middle) {
                // Interior: all neighbours of these elements are in the domain.
                if (part.begin < part.end) {
                    const uint3 address{part.begin, row.y, row.z};
                    // near.glift:9
                    const uint f_extent_yx = f_extent.y * f_extent.x;
                    // near.glift:10
                    const uint3 f_address = f_origin + address;
                    // near.glift:9
                    const uint f_at = (f_address.z * f_extent.y + f_address.y) * f_extent.x + f_address.x;
                    // near.glift:12
                    const uint3 g_address = g_origin + address;
                    // near.glift:9
                    const uint g_at = (g_address.z * g_extent.y + g_address.y) * g_extent.x + g_address.x;
                    const float* f_data_row = glift::host::row_pointer(f_data + f_at);
                    const float* f_data_row_2 = glift::host::row_pointer(f_data + (f_at + 1u));
                    const float* f_data_row_3 = glift::host::row_pointer(f_data + (f_at - 1u));
                    const float* f_data_row_4 = glift::host::row_pointer(f_data + (f_at + f_extent.x));
                    const float* f_data_row_5 = glift::host::row_pointer(f_data + (f_at - f_extent.x));
                    const float* f_data_row_6 = glift::host::row_pointer(f_data + (f_at + f_extent_yx));
                    const float* f_data_row_7 = glift::host::row_pointer(f_data + (f_at - f_extent_yx));
                    float* g_data_row = glift::host::row_pointer(g_data + g_at);
                    const std::size_t count = part.end - part.begin;
                    for (std::size_t block = 0; block < count; block += glift::host::block_elements) {
                        const std::size_t first = glift::host::begin_of_block(block, count);
                        GLIFT_BLOCK
                        for (std::size_t lane = 0; lane < glift::host::block_elements; ++lane) {
                            const std::size_t i = first + lane;
                            // near.glift:10
                            float sum = -6.0f * f_data_row[i];
                            // near.glift:11
                            sum += f_data_row_2[i] + f_data_row_3[i];
                            sum += f_data_row_4[i] + f_data_row_5[i];
                            sum += f_data_row_6[i] + f_data_row_7[i];
                            // near.glift:12
                            g_data_row[i] = sum;
                        }
                    }
                }
            } else {
                // Elsewhere: neighbours may be outside the domain.
                if (part.begin < part.end) {
                    const uint3 address{part.begin, row.y, row.z};
                    // near.glift:9
                    const uint f_extent_yx = f_extent.y * f_extent.x;
                    // near.glift:10
                    const uint3 f_address = f_origin + address;
                    // near.glift:9
                    const uint f_at = (f_address.z * f_extent.y + f_address.y) * f_extent.x + f_address.x;
                    // near.glift:12
                    const uint3 g_address = g_origin + address;
                    // near.glift:9
                    const uint g_at = (g_address.z * g_extent.y + g_address.y) * g_extent.x + g_address.x;
                    // near.glift:11
                    const bool f_yp1_inside = f_address.y + 1u < f_extent.y;
                    const bool f_ym1_inside = f_address.y >= 1u;
                    const bool f_zp1_inside = f_address.z + 1u < f_extent.z;
                    const bool f_zm1_inside = f_address.z >= 1u;
                    const float* f_data_row = glift::host::row_pointer(f_data + f_at);
                    const float* f_data_row_2 = glift::host::row_pointer(f_data
                        + (f_at + (f_yp1_inside ? f_extent.x : 0u)));
                    const float* f_data_row_3 = glift::host::row_pointer(f_data
                        + (f_at - (f_ym1_inside ? f_extent.x : 0u)));
                    const float* f_data_row_4 = glift::host::row_pointer(f_data
                        + (f_at + (f_zp1_inside ? f_extent_yx : 0u)));
                    const float* f_data_row_5 = glift::host::row_pointer(f_data
                        + (f_at - (f_zm1_inside ? f_extent_yx : 0u)));
                    float* g_data_row = glift::host::row_pointer(g_data + g_at);
                    GLIFT_INDEPENDENT
                    for (std::size_t i = 0, count = part.end - part.begin; i < count; ++i) {
                        const uint3 address{part.begin + static_cast<uint>(i), row.y, row.z};
                        // near.glift:10
                        const uint3 f_address_2 = f_origin + address;
                        // near.glift:9
                        const uint f_at_2 = (f_address_2.z * f_extent.y + f_address_2.y) * f_extent.x + f_address_2.x;
                        // near.glift:10
                        float sum = -6.0f * f_data_row[i];
                        // near.glift:11
                        const bool f_xp1_inside = f_address_2.x + 1u < f_extent.x;
                        const float f_xp1 = f_data[f_at_2 + (f_xp1_inside ? 1u : 0u)];
                        const bool f_xm1_inside = f_address_2.x >= 1u;
                        const float f_xm1 = f_data[f_at_2 - (f_xm1_inside ? 1u : 0u)];
                        sum += (f_xp1_inside ? f_xp1 : 0.0f) + (f_xm1_inside ? f_xm1 : 0.0f);
                        const bool f_yp1_inside_2 = f_address_2.y + 1u < f_extent.y;
                        const float f_yp1 = f_data_row_2[i];
                        const bool f_ym1_inside_2 = f_address_2.y >= 1u;
                        const float f_ym1 = f_data_row_3[i];
                        sum += (f_yp1_inside_2 ? f_yp1 : 0.0f) + (f_ym1_inside_2 ? f_ym1 : 0.0f);
                        const bool f_zp1_inside_2 = f_address_2.z + 1u < f_extent.z;
                        const float f_zp1 = f_data_row_4[i];
                        const bool f_zm1_inside_2 = f_address_2.z >= 1u;
                        const float f_zm1 = f_data_row_5[i];
                        sum += (f_zp1_inside_2 ? f_zp1 : 0.0f) + (f_zm1_inside_2 ? f_zm1 : 0.0f);
                        // near.glift:12
                        g_data_row[i] = sum;
                    }
                }
            }
        }
    }
}

static void smooth_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { smooth_general_rows(call, rows); });
}

const glift::Binding smooth_bindings[] = {
    {.name = "f.data", .address_offset = 72, .element_bytes = sizeof(float), .reach = glift::Reach::window,
        .radius = 1},
    {.name = "g.data", .access = glift::Access::write, .address_offset = 80, .element_bytes = sizeof(float),
        .parameter = 1, .reach = glift::Reach::element, .update = glift::Update::assign, .number = glift::Number::real},
};
constexpr glift::Parameter smooth_parameters[] = {{"f_extent", 0, 12}};
}  // namespace

extern const glift::Kernel smooth_kernel;
const glift::Kernel smooth_kernel = {
    .name = "smooth",
    .file = "near.glift",
    .line = 9,
    .rank = 3,
    .group = {32, 4, 2},
    .loop_rounds = 0,
    .bindings = smooth_bindings,
    .direct = {.parameter_bytes = 12, .push_constants = true},
    .general = {.host = &smooth_general, .parameter_bytes = 88, .uniform_buffer = true, .base_offset = 36},
    .parameters = smooth_parameters,
    .items = {1, 2, 1},
};

}  // namespace near_

