// Made by gliftc from near.glift. Changes are lost when it is made again.
#include "near.glift.hpp"

#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>

#include <optional>

namespace near_ {

using namespace glift::types;

namespace {

/// Elements of a box in a linear buffer, first axis fastest: what the host reads and writes.
class Box_3_float : public glift::Structure<Box_3_float, uint3, float> {
public:
    static constexpr const char* type_name = "Box<3, float>";

    Box_3_float() = default;
    [[maybe_unused]] Box_3_float(const glift::Commands& commands, uint3 extent);
    /// Over parts that exist already.
    [[maybe_unused]] Box_3_float(const glift::Commands& commands, uint3 extent, glift::Memory data);

    /// The extent of the virtual domain.
    [[maybe_unused]] uint3 domain() const;
    uint3 extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    uint data_extent() const { return data_extent_; }
    /// True if the two were made with equal arguments.
    [[maybe_unused]] bool same_state(const Box_3_float& other) const;

private:
    uint3 extent_{};
    uint data_extent_{};
    glift::Memory data_;
};

// address.glift:17: volume<3>
inline uint volume(uint3 extent) {
    // address.glift:18
    uint product = extent.x;
    // address.glift:19
    for (uint axis = 1u; axis < 3u; ++axis) {
        // address.glift:20
        product *= extent[axis];
    }
    // address.glift:22
    return product;
}

// address.glift:26: linearize<3>
inline uint linearize(uint3 address, uint3 extent) {
    // address.glift:27
    uint index = address.z;
    // address.glift:28
    for (uint back = 1u; back < 3u; ++back) {
        // address.glift:29
        index = index * extent[3u - 1u - back] + address[3u - 1u - back];
    }
    // address.glift:31
    return index;
}

// ----------------------------------------------------------------------------------------------------
// near.glift:9: smooth

struct smooth_direct_parameters {
    uint3 f_extent;
};
static_assert(offsetof(smooth_direct_parameters, f_extent) == 0);

// near.glift:9: smooth, some rows.
GLIFT_HOST_KERNEL
static void smooth_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const smooth_direct_parameters*>(call.parameters);
    const uint3 f_extent = parameters.f_extent;
    const float* f_data = glift::host::elements<const float>(call.memories[0]);
    float* g_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        const glift::host::Part interior = glift::host::in_blocks(glift::host::interior_of(row, uint3(), f_extent, 1),
            row.end);
        for (const glift::host::Section& part : glift::host::sections(row.begin, interior, row.end)) {
            if (part.is_middle) {
                // All neighbours exist.
                if (part.begin < part.end) {
                    const uint3 address{part.begin, row.y, row.z};
                    // near.glift:9
                    const uint f_extent_yx = f_extent.y * f_extent.x;
                    const uint f_at = (address.z * f_extent.y + address.y) * f_extent.x + address.x;
                    const float* f_data_row = glift::host::row_pointer(f_data + f_at);
                    const float* f_data_row_2 = glift::host::row_pointer(f_data + (f_at + 1u));
                    const float* f_data_row_3 = glift::host::row_pointer(f_data + (f_at - 1u));
                    const float* f_data_row_4 = glift::host::row_pointer(f_data + (f_at + f_extent.x));
                    const float* f_data_row_5 = glift::host::row_pointer(f_data + (f_at - f_extent.x));
                    const float* f_data_row_6 = glift::host::row_pointer(f_data + (f_at + f_extent_yx));
                    const float* f_data_row_7 = glift::host::row_pointer(f_data + (f_at - f_extent_yx));
                    float* g_data_row = glift::host::row_pointer(g_data + f_at);
                    const std::size_t count = part.end - part.begin;
                    for (std::size_t block = 0; block < count; block += glift::host::block_elements) {
                        const std::size_t first = std::min(block, count - glift::host::block_elements);
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
                // Near the sides of the domain.
                if (part.begin < part.end) {
                    const uint3 address{part.begin, row.y, row.z};
                    // near.glift:9
                    const uint f_extent_yx = f_extent.y * f_extent.x;
                    const uint f_at = (address.z * f_extent.y + address.y) * f_extent.x + address.x;
                    // near.glift:11
                    const bool f_yp1_inside = address.y + 1u < f_extent.y;
                    const bool f_ym1_inside = address.y >= 1u;
                    const bool f_zp1_inside = address.z + 1u < f_extent.z;
                    const bool f_zm1_inside = address.z >= 1u;
                    const float* f_data_row = glift::host::row_pointer(f_data + f_at);
                    const float* f_data_row_2 = glift::host::row_pointer(f_data
                        + (f_at + (f_yp1_inside ? f_extent.x : 0u)));
                    const float* f_data_row_3 = glift::host::row_pointer(f_data
                        + (f_at - (f_ym1_inside ? f_extent.x : 0u)));
                    const float* f_data_row_4 = glift::host::row_pointer(f_data
                        + (f_at + (f_zp1_inside ? f_extent_yx : 0u)));
                    const float* f_data_row_5 = glift::host::row_pointer(f_data
                        + (f_at - (f_zm1_inside ? f_extent_yx : 0u)));
                    float* g_data_row = glift::host::row_pointer(g_data + f_at);
                    GLIFT_INDEPENDENT
                    for (std::size_t i = 0, count = part.end - part.begin; i < count; ++i) {
                        const uint3 address{part.begin + static_cast<uint>(i), row.y, row.z};
                        // near.glift:9
                        const uint f_at_2 = (address.z * f_extent.y + address.y) * f_extent.x + address.x;
                        // near.glift:10
                        float sum = -6.0f * f_data_row[i];
                        // near.glift:11
                        const bool f_xp1_inside = address.x + 1u < f_extent.x;
                        const float f_xp1 = f_data[f_at_2 + (f_xp1_inside ? 1u : 0u)];
                        const bool f_xm1_inside = address.x >= 1u;
                        const float f_xm1 = f_data[f_at_2 - (f_xm1_inside ? 1u : 0u)];
                        sum += (f_xp1_inside ? f_xp1 : 0.0f) + (f_xm1_inside ? f_xm1 : 0.0f);
                        const bool f_yp1_inside_2 = address.y + 1u < f_extent.y;
                        const float f_yp1 = f_data_row_2[i];
                        const bool f_ym1_inside_2 = address.y >= 1u;
                        const float f_ym1 = f_data_row_3[i];
                        sum += (f_yp1_inside_2 ? f_yp1 : 0.0f) + (f_ym1_inside_2 ? f_ym1 : 0.0f);
                        const bool f_zp1_inside_2 = address.z + 1u < f_extent.z;
                        const float f_zp1 = f_data_row_4[i];
                        const bool f_zm1_inside_2 = address.z >= 1u;
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

static void smooth_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { smooth_direct_rows(call, rows); });
}

struct smooth_general_parameters {
    uint3 size;
    uint3 f_origin;
    uint3 g_origin;
    uint3 f_extent;
    uint3 g_extent;
};
static_assert(offsetof(smooth_general_parameters, size) == 0);
static_assert(offsetof(smooth_general_parameters, f_origin) == 12);
static_assert(offsetof(smooth_general_parameters, g_origin) == 24);
static_assert(offsetof(smooth_general_parameters, f_extent) == 36);
static_assert(offsetof(smooth_general_parameters, g_extent) == 48);

// near.glift:9: smooth, some rows.
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
                // All neighbours exist.
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
                        const std::size_t first = std::min(block, count - glift::host::block_elements);
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
                // Near the sides of the domain.
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
    {.name = "f.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 64,
        .reach = glift::Reach::window, .radius = 1},
    {.name = "g.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 72,
        .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter smooth_parameters[] = {
    {"f_extent", 0, sizeof(smooth_direct_parameters::f_extent)},
};
const glift::Kernel smooth_kernel = {
    .name = "smooth",
    .file = "near.glift",
    .line = 9,
    .rank = 3,
    .group = {32, 4, 2},
    .loop_rounds = 0,
    .bindings = smooth_bindings,
    .direct = {.host = &smooth_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &smooth_general, .parameter_bytes = 60},
    .wide = {},
    .parameters = smooth_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Array<3, float, none, buffer>, Box<3, float>>

struct read_box_direct_parameters {
    uint3 from_extent;
    uint3 to_extent;
};
static_assert(offsetof(read_box_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_direct_parameters, to_extent) == 12);

// transfer.glift:15: read_box<Array<3, float, none, buffer>, Box<3, float>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_direct_parameters*>(call.parameters);
    const uint3 from_extent = parameters.from_extent;
    const uint3 to_extent = parameters.to_extent;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint3 address{row.begin, row.y, row.z};
            // transfer.glift:15
            const uint from_at = (address.z * from_extent.y + address.y) * from_extent.x + address.x;
            const uint to_at = (address.z * to_extent.y + address.y) * to_extent.x + address.x;
            const float* from_data_row = glift::host::row_pointer(from_data + from_at);
            float* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:16
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void read_box_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_direct_rows(call, rows); });
}

struct read_box_general_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 from_extent;
    uint3 to_extent;
};
static_assert(offsetof(read_box_general_parameters, size) == 0);
static_assert(offsetof(read_box_general_parameters, from_origin) == 12);
static_assert(offsetof(read_box_general_parameters, to_origin) == 24);
static_assert(offsetof(read_box_general_parameters, from_extent) == 36);
static_assert(offsetof(read_box_general_parameters, to_extent) == 48);

// transfer.glift:15: read_box<Array<3, float, none, buffer>, Box<3, float>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_general_parameters*>(call.parameters);
    const uint3 from_origin = parameters.from_origin;
    const uint3 to_origin = parameters.to_origin;
    const uint3 from_extent = parameters.from_extent;
    const uint3 to_extent = parameters.to_extent;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint3 address{row.begin, row.y, row.z};
            // transfer.glift:16
            const uint3 from_address = from_origin + address;
            // transfer.glift:15
            const uint from_at = (from_address.z * from_extent.y + from_address.y) * from_extent.x + from_address.x;
            // transfer.glift:16
            const uint3 to_address = to_origin + address;
            // transfer.glift:15
            const uint to_at = (to_address.z * to_extent.y + to_address.y) * to_extent.x + to_address.x;
            const float* from_data_row = glift::host::row_pointer(from_data + from_at);
            float* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:16
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void read_box_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_general_rows(call, rows); });
}

const glift::Binding read_box_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 64,
        .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 72,
        .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter read_box_parameters[] = {
    {"from_extent", 0, sizeof(read_box_direct_parameters::from_extent)},
    {"to_extent", 12, sizeof(read_box_direct_parameters::to_extent)},
};
const glift::Kernel read_box_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 3,
    .group = {32, 4, 2},
    .loop_rounds = 0,
    .bindings = read_box_bindings,
    .direct = {.host = &read_box_direct, .parameter_bytes = 24, .push_constants = true},
    .general = {.host = &read_box_general, .parameter_bytes = 60},
    .wide = {},
    .parameters = read_box_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<3, float>, Array<3, float, none, buffer>>

struct write_box_direct_parameters {
    uint3 from_extent;
    uint3 to_extent;
};
static_assert(offsetof(write_box_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_direct_parameters, to_extent) == 12);

// transfer.glift:20: write_box<Box<3, float>, Array<3, float, none, buffer>>, some rows.
GLIFT_HOST_KERNEL
static void write_box_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_direct_parameters*>(call.parameters);
    const uint3 from_extent = parameters.from_extent;
    const uint3 to_extent = parameters.to_extent;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint3 address{row.begin, row.y, row.z};
            // transfer.glift:20
            const uint from_at = (address.z * from_extent.y + address.y) * from_extent.x + address.x;
            const uint to_at = (address.z * to_extent.y + address.y) * to_extent.x + address.x;
            const float* from_data_row = glift::host::row_pointer(from_data + from_at);
            float* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:21
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void write_box_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_direct_rows(call, rows); });
}

struct write_box_general_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 from_extent;
    uint3 to_extent;
};
static_assert(offsetof(write_box_general_parameters, size) == 0);
static_assert(offsetof(write_box_general_parameters, from_origin) == 12);
static_assert(offsetof(write_box_general_parameters, to_origin) == 24);
static_assert(offsetof(write_box_general_parameters, from_extent) == 36);
static_assert(offsetof(write_box_general_parameters, to_extent) == 48);

// transfer.glift:20: write_box<Box<3, float>, Array<3, float, none, buffer>>, some rows.
GLIFT_HOST_KERNEL
static void write_box_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_general_parameters*>(call.parameters);
    const uint3 from_origin = parameters.from_origin;
    const uint3 to_origin = parameters.to_origin;
    const uint3 from_extent = parameters.from_extent;
    const uint3 to_extent = parameters.to_extent;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint3 address{row.begin, row.y, row.z};
            // transfer.glift:21
            const uint3 from_address = from_origin + address;
            // transfer.glift:20
            const uint from_at = (from_address.z * from_extent.y + from_address.y) * from_extent.x + from_address.x;
            // transfer.glift:21
            const uint3 to_address = to_origin + address;
            // transfer.glift:20
            const uint to_at = (to_address.z * to_extent.y + to_address.y) * to_extent.x + to_address.x;
            const float* from_data_row = glift::host::row_pointer(from_data + from_at);
            float* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:21
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void write_box_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_general_rows(call, rows); });
}

const glift::Binding write_box_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 64,
        .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 72,
        .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter write_box_parameters[] = {
    {"from_extent", 0, sizeof(write_box_direct_parameters::from_extent)},
    {"to_extent", 12, sizeof(write_box_direct_parameters::to_extent)},
};
const glift::Kernel write_box_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 3,
    .group = {32, 4, 2},
    .loop_rounds = 0,
    .bindings = write_box_bindings,
    .direct = {.host = &write_box_direct, .parameter_bytes = 24, .push_constants = true},
    .general = {.host = &write_box_general, .parameter_bytes = 60},
    .wide = {},
    .parameters = write_box_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Array<3, float, none, buffer>, float>

struct fill_box_direct_parameters {
    uint3 to_extent;
    float value;
};
static_assert(offsetof(fill_box_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_direct_parameters, value) == 12);

// transfer.glift:25: fill_box<Array<3, float, none, buffer>, float>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_direct_parameters*>(call.parameters);
    const uint3 to_extent = parameters.to_extent;
    const float value = parameters.value;
    float* to_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint3 address{row.begin, row.y, row.z};
            // transfer.glift:25
            const uint to_at = (address.z * to_extent.y + address.y) * to_extent.x + address.x;
            float* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:26
                to_data_row[i] = value;
            }
        }
    }
}

static void fill_box_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_direct_rows(call, rows); });
}

struct fill_box_general_parameters {
    uint3 size;
    uint3 to_origin;
    uint3 to_extent;
    float value;
};
static_assert(offsetof(fill_box_general_parameters, size) == 0);
static_assert(offsetof(fill_box_general_parameters, to_origin) == 12);
static_assert(offsetof(fill_box_general_parameters, to_extent) == 24);
static_assert(offsetof(fill_box_general_parameters, value) == 36);

// transfer.glift:25: fill_box<Array<3, float, none, buffer>, float>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_general_parameters*>(call.parameters);
    const uint3 to_origin = parameters.to_origin;
    const uint3 to_extent = parameters.to_extent;
    const float value = parameters.value;
    float* to_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint3 address{row.begin, row.y, row.z};
            // transfer.glift:26
            const uint3 to_address = to_origin + address;
            // transfer.glift:25
            const uint to_at = (to_address.z * to_extent.y + to_address.y) * to_extent.x + to_address.x;
            float* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:26
                to_data_row[i] = value;
            }
        }
    }
}

static void fill_box_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_general_rows(call, rows); });
}

const glift::Binding fill_box_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 40},
};
constexpr glift::Parameter fill_box_parameters[] = {
    {"to_extent", 0, sizeof(fill_box_direct_parameters::to_extent)},
    {"value", 12, sizeof(fill_box_direct_parameters::value)},
};
const glift::Kernel fill_box_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 3,
    .group = {32, 4, 2},
    .loop_rounds = 0,
    .bindings = fill_box_bindings,
    .direct = {.host = &fill_box_direct, .parameter_bytes = 16, .push_constants = true},
    .general = {.host = &fill_box_general, .parameter_bytes = 40},
    .wide = {},
    .parameters = fill_box_parameters,
    .items = {1, 2, 1},
};

void read_box(const glift::Commands& commands, const glift::Range<Field>& from, const glift::Range<Box_3_float>& to) {
    glift::Iteration iteration(read_box_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (iteration.is_whole() && !commands.needs_general(read_box_kernel, memories, iteration.size())) {
        const read_box_direct_parameters parameters = {
            .from_extent = from->extent(),
            .to_extent = to->extent(),
        };
        commands.dispatch(read_box_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const read_box_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent = from->extent(),
            .to_extent = to->extent(),
        };
        commands.dispatch(read_box_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(read_box_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void write_box(const glift::Commands& commands, const glift::Range<Box_3_float>& from, const glift::Range<Field>& to) {
    glift::Iteration iteration(write_box_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (iteration.is_whole() && !commands.needs_general(write_box_kernel, memories, iteration.size())) {
        const write_box_direct_parameters parameters = {
            .from_extent = from->extent(),
            .to_extent = to->extent(),
        };
        commands.dispatch(write_box_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const write_box_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent = from->extent(),
            .to_extent = to->extent(),
        };
        commands.dispatch(write_box_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(write_box_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void fill_box(const glift::Commands& commands, const glift::Range<Field>& to, float value) {
    glift::Iteration iteration(fill_box_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (iteration.is_whole() && !commands.needs_general(fill_box_kernel, memories, iteration.size())) {
        const fill_box_direct_parameters parameters = {
            .to_extent = to->extent(),
            .value = value,
        };
        commands.dispatch(fill_box_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const fill_box_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .to_extent = to->extent(),
            .value = value,
        };
        commands.dispatch(fill_box_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(fill_box_general_parameters, size)})});
    }
}

Box_3_float::Box_3_float(const glift::Commands& commands, uint3 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.allocate({.name = "Box_3_float.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

Box_3_float::Box_3_float(const glift::Commands& commands, uint3 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Box_3_float.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

uint3 Box_3_float::domain() const {
    return extent_;
}

bool Box_3_float::same_state(const Box_3_float& other) const {
    return extent_ == other.extent_;
}

}  // namespace

void smooth(const glift::Commands& commands, const glift::Range<Field>& f, const glift::Range<Field>& g) {
    glift::Iteration iteration(smooth_kernel);
    iteration.each("g", g);
    iteration.near("f", f);
    const glift::Memory memories[] = {f->data(), g->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {f, g});
    if (iteration.is_whole() && f->same_state(g.structure())
        && !commands.needs_general(smooth_kernel, memories, iteration.size())) {
        const smooth_direct_parameters parameters = {
            .f_extent = f->extent(),
        };
        commands.dispatch(smooth_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const smooth_general_parameters parameters = {
            .size = g.size(),
            .f_origin = iteration.centre(f),
            .g_origin = g.origin(),
            .f_extent = f->extent(),
            .g_extent = g->extent(),
        };
        commands.dispatch(smooth_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(smooth_general_parameters, size)}), .sharing = iteration.sharing()});
    }
}

Field::Field(const glift::Commands& commands, uint3 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.allocate({.name = "Field.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

Field::Field(const glift::Commands& commands, uint3 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Field.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

uint3 Field::domain() const {
    return extent_;
}

bool Field::same_state(const Field& other) const {
    return extent_ == other.extent_;
}

std::uint64_t Field::place(uint3 address) const {
    [[maybe_unused]] const uint3 extent = extent_;
    const auto translate = [&](uint3 va) -> uint {
        // linear.glift:12
        return linearize(va, extent);
    };
    return translate(address);
}

void Field::copy_out(const glift::Commands& commands, const glift::Range<Field>& range,
    const glift::Memory& box) const {
    read_box(commands, range, Box_3_float(commands, range.size(), box));
}

void Field::copy_in(const glift::Commands& commands, const glift::Range<Field>& range, const glift::Memory& box) const {
    write_box(commands, Box_3_float(commands, range.size(), box), range);
}

void Field::fill(float value, const glift::Range<Field>& range) {
    fill_box(device(), range, value);
}
void Field::fill(float value) {
    fill(value, *this);
}

}  // namespace near_
