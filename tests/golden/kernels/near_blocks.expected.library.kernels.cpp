// Made by gliftc from near_blocks.glift. Changes are lost when it is made again.
#include "near_blocks.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace std_transfer {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Listed, Box<2, float>>

namespace {
struct read_box_9bb01b1e_direct_parameters {
    uint2 from_extent;
    uint div_ceil_x;
    uint from_table_extent;
    uint2 from_frames_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_9bb01b1e_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_9bb01b1e_direct_parameters, div_ceil_x) == 8);
static_assert(offsetof(read_box_9bb01b1e_direct_parameters, from_table_extent) == 12);
static_assert(offsetof(read_box_9bb01b1e_direct_parameters, from_frames_extent) == 16);
static_assert(offsetof(read_box_9bb01b1e_direct_parameters, to_extent_x) == 24);

// transfer.glift:15: read_box<Listed, Box<2, float>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_9bb01b1e_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_9bb01b1e_direct_parameters*>(call.parameters);
    const uint div_ceil_x = parameters.div_ceil_x;
    const uint from_table_extent = parameters.from_table_extent;
    const uint2 from_frames_extent = parameters.from_frames_extent;
    const uint to_extent_x = parameters.to_extent_x;
    const uint* from_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_frames_data = glift::host::elements<const float>(call.memories[1]);
    float* to_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:15
            const uint to_at = address.y * to_extent_x + address.x;
            float* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint2 address{row.begin + static_cast<uint>(i), row.y};
                // transfer.glift:15
                const uint from_table_address = address.y / 8u * div_ceil_x + address.x / 8u;
                const bool from_table_value_inside = from_table_address < from_table_extent;
                const uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
                const uint from_entry = from_table_value_inside ? from_table_value : 0u;
                const uint2 from_place = uint2(address.y % 8u * 8u + address.x % 8u, from_entry - 1u);
                const uint from_at = from_place.y * from_frames_extent.x + from_place.x;
                const bool from_found = !(from_entry == 0u) && from_place.y < from_frames_extent.y;
                // transfer.glift:16
                const float from_value = from_frames_data[from_found ? from_at : 0u];
                to_data_row[i] = from_found ? from_value : 0.0f;
            }
        }
    }
}

static void read_box_9bb01b1e_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_9bb01b1e_direct_rows(call, rows); });
}

struct read_box_9bb01b1e_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint div_ceil_x;
    uint from_table_extent;
    uint2 from_frames_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_9bb01b1e_general_parameters, size) == 0);
static_assert(offsetof(read_box_9bb01b1e_general_parameters, from_origin) == 8);
static_assert(offsetof(read_box_9bb01b1e_general_parameters, to_origin) == 16);
static_assert(offsetof(read_box_9bb01b1e_general_parameters, div_ceil_x) == 24);
static_assert(offsetof(read_box_9bb01b1e_general_parameters, from_table_extent) == 28);
static_assert(offsetof(read_box_9bb01b1e_general_parameters, from_frames_extent) == 32);
static_assert(offsetof(read_box_9bb01b1e_general_parameters, to_extent_x) == 40);

// transfer.glift:15: read_box<Listed, Box<2, float>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_9bb01b1e_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_9bb01b1e_general_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const uint div_ceil_x = parameters.div_ceil_x;
    const uint from_table_extent = parameters.from_table_extent;
    const uint2 from_frames_extent = parameters.from_frames_extent;
    const uint to_extent_x = parameters.to_extent_x;
    const uint* from_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_frames_data = glift::host::elements<const float>(call.memories[1]);
    float* to_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:16
            const uint2 to_address = to_origin + address;
            // transfer.glift:15
            const uint to_at = to_address.y * to_extent_x + to_address.x;
            float* to_data_row = glift::host::row_pointer(to_data + to_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint2 address{row.begin + static_cast<uint>(i), row.y};
                // transfer.glift:16
                const uint2 from_address = from_origin + address;
                // transfer.glift:15
                const uint from_table_address = from_address.y / 8u * div_ceil_x + from_address.x / 8u;
                const bool from_table_value_inside = from_table_address < from_table_extent;
                const uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
                const uint from_entry = from_table_value_inside ? from_table_value : 0u;
                const uint2 from_place = uint2(from_address.y % 8u * 8u + from_address.x % 8u, from_entry - 1u);
                const uint from_at = from_place.y * from_frames_extent.x + from_place.x;
                const bool from_found = !(from_entry == 0u) && from_place.y < from_frames_extent.y;
                // transfer.glift:16
                const float from_value = from_frames_data[from_found ? from_at : 0u];
                to_data_row[i] = from_found ? from_value : 0.0f;
            }
        }
    }
}

static void read_box_9bb01b1e_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_9bb01b1e_general_rows(call,
        rows); });
}

struct read_box_9bb01b1e_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    uint div_ceil_x;
    uint from_table_extent;
    std::uint64_t from_frames_extent_x;
    uint from_frames_extent_y;
    std::uint64_t to_extent_x;
    std::uint64_t from_table_data_address;
    std::uint64_t from_frames_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_9bb01b1e_wide_parameters, size) == 0);
static_assert(offsetof(read_box_9bb01b1e_wide_parameters, from_origin) == 8);
static_assert(offsetof(read_box_9bb01b1e_wide_parameters, to_origin) == 16);
static_assert(offsetof(read_box_9bb01b1e_wide_parameters, base) == 24);
static_assert(offsetof(read_box_9bb01b1e_wide_parameters, div_ceil_x) == 36);
static_assert(offsetof(read_box_9bb01b1e_wide_parameters, from_table_extent) == 40);
static_assert(offsetof(read_box_9bb01b1e_wide_parameters, from_frames_extent_x) == 48);
static_assert(offsetof(read_box_9bb01b1e_wide_parameters, from_frames_extent_y) == 56);
static_assert(offsetof(read_box_9bb01b1e_wide_parameters, to_extent_x) == 64);
static_assert(offsetof(read_box_9bb01b1e_wide_parameters, from_table_data_address) == 72);
static_assert(offsetof(read_box_9bb01b1e_wide_parameters, from_frames_data_address) == 80);
static_assert(offsetof(read_box_9bb01b1e_wide_parameters, to_data_address) == 88);

// transfer.glift:15: read_box<Listed, Box<2, float>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_9bb01b1e_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_9bb01b1e_wide_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const uint div_ceil_x = parameters.div_ceil_x;
    const uint from_table_extent = parameters.from_table_extent;
    const std::uint64_t from_frames_extent_x = parameters.from_frames_extent_x;
    const uint from_frames_extent_y = parameters.from_frames_extent_y;
    const std::uint64_t to_extent_x = parameters.to_extent_x;
    const uint* from_table_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_frames_data = glift::host::elements<const float>(call.memories[1]);
    float* to_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:16
            const uint2 from_address = from_origin + address;
            // transfer.glift:15
            const uint from_table_address = from_address.y / 8u * div_ceil_x + from_address.x / 8u;
            const bool from_table_value_inside = from_table_address < from_table_extent;
            const std::uint64_t from_table_value_at = std::uint64_t(from_table_address);
            const uint from_table_value = from_table_data[from_table_value_inside ? from_table_value_at
                : std::uint64_t{0u}];
            const uint from_entry = from_table_value_inside ? from_table_value : 0u;
            const uint2 from_place = uint2(from_address.y % 8u * 8u + from_address.x % 8u, from_entry - 1u);
            const std::uint64_t from_at = std::uint64_t(from_place.y) * from_frames_extent_x
                + std::uint64_t(from_place.x);
            const bool from_found = !(from_entry == 0u) && from_place.y < from_frames_extent_y;
            // transfer.glift:16
            const uint2 to_address = to_origin + address;
            // transfer.glift:15
            const std::uint64_t to_at = std::uint64_t(to_address.y) * to_extent_x + std::uint64_t(to_address.x);
            // transfer.glift:16
            const float from_value = from_frames_data[from_found ? from_at : std::uint64_t{0u}];
            to_data[to_at] = from_found ? from_value : 0.0f;
        }
    }
}

static void read_box_9bb01b1e_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_9bb01b1e_wide_rows(call, rows); });
}

const glift::Binding read_box_9bb01b1e_bindings[] = {
    {.name = "from.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 72,
        .element_bytes = sizeof(uint)},
    {.name = "from.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 80,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 88,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter read_box_9bb01b1e_parameters[] = {
    {"from_extent", 0, sizeof(read_box_9bb01b1e_direct_parameters::from_extent)},
    {"div_ceil_x", 8, sizeof(read_box_9bb01b1e_direct_parameters::div_ceil_x)},
    {"from_table_extent", 12, sizeof(read_box_9bb01b1e_direct_parameters::from_table_extent)},
    {"from_frames_extent", 16, sizeof(read_box_9bb01b1e_direct_parameters::from_frames_extent)},
    {"to_extent_x", 24, sizeof(read_box_9bb01b1e_direct_parameters::to_extent_x)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_9bb01b1e_kernel;
const glift::Kernel read_box_9bb01b1e_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = read_box_9bb01b1e_bindings,
    .direct = {.host = &read_box_9bb01b1e_direct, .parameter_bytes = 28, .push_constants = true},
    .general = {.host = &read_box_9bb01b1e_general, .parameter_bytes = 44},
    .wide = {.host = &read_box_9bb01b1e_wide, .parameter_bytes = 96, .base_offset = 24},
    .parameters = read_box_9bb01b1e_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<2, float>, Listed>

namespace {
struct write_box_bdc9234f_direct_parameters {
    uint2 from_extent;
    uint div_ceil_x;
    uint to_table_extent;
    uint2 to_frames_extent;
};
static_assert(offsetof(write_box_bdc9234f_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_bdc9234f_direct_parameters, div_ceil_x) == 8);
static_assert(offsetof(write_box_bdc9234f_direct_parameters, to_table_extent) == 12);
static_assert(offsetof(write_box_bdc9234f_direct_parameters, to_frames_extent) == 16);

// transfer.glift:20: write_box<Box<2, float>, Listed>, some rows.
GLIFT_HOST_KERNEL
static void write_box_bdc9234f_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_bdc9234f_direct_parameters*>(call.parameters);
    const uint2 from_extent = parameters.from_extent;
    const uint div_ceil_x = parameters.div_ceil_x;
    const uint to_table_extent = parameters.to_table_extent;
    const uint2 to_frames_extent = parameters.to_frames_extent;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    const uint* to_table_data = glift::host::elements<const uint>(call.memories[1]);
    float* to_frames_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:20
            const uint from_at = address.y * from_extent.x + address.x;
            const uint to_table_address = address.y / 8u * div_ceil_x + address.x / 8u;
            const bool to_table_value_inside = to_table_address < to_table_extent;
            const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
            const uint to_entry = to_table_value_inside ? to_table_value : 0u;
            const uint2 to_place = uint2(address.y % 8u * 8u + address.x % 8u, to_entry - 1u);
            const uint to_at = to_place.y * to_frames_extent.x + to_place.x;
            const bool to_found = !(to_entry == 0u) && to_place.y < to_frames_extent.y;
            // transfer.glift:21
            if (to_found) {
                to_frames_data[to_at] = from_data[from_at];
            }
        }
    }
}

static void write_box_bdc9234f_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_bdc9234f_direct_rows(call,
        rows); });
}

struct write_box_bdc9234f_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
    uint div_ceil_x;
    uint to_table_extent;
    uint2 to_frames_extent;
};
static_assert(offsetof(write_box_bdc9234f_general_parameters, size) == 0);
static_assert(offsetof(write_box_bdc9234f_general_parameters, from_origin) == 8);
static_assert(offsetof(write_box_bdc9234f_general_parameters, to_origin) == 16);
static_assert(offsetof(write_box_bdc9234f_general_parameters, from_extent_x) == 24);
static_assert(offsetof(write_box_bdc9234f_general_parameters, div_ceil_x) == 28);
static_assert(offsetof(write_box_bdc9234f_general_parameters, to_table_extent) == 32);
static_assert(offsetof(write_box_bdc9234f_general_parameters, to_frames_extent) == 36);

// transfer.glift:20: write_box<Box<2, float>, Listed>, some rows.
GLIFT_HOST_KERNEL
static void write_box_bdc9234f_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_bdc9234f_general_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const uint from_extent_x = parameters.from_extent_x;
    const uint div_ceil_x = parameters.div_ceil_x;
    const uint to_table_extent = parameters.to_table_extent;
    const uint2 to_frames_extent = parameters.to_frames_extent;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    const uint* to_table_data = glift::host::elements<const uint>(call.memories[1]);
    float* to_frames_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:21
            const uint2 from_address = from_origin + address;
            // transfer.glift:20
            const uint from_at = from_address.y * from_extent_x + from_address.x;
            // transfer.glift:21
            const uint2 to_address = to_origin + address;
            // transfer.glift:20
            const uint to_table_address = to_address.y / 8u * div_ceil_x + to_address.x / 8u;
            const bool to_table_value_inside = to_table_address < to_table_extent;
            const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
            const uint to_entry = to_table_value_inside ? to_table_value : 0u;
            const uint2 to_place = uint2(to_address.y % 8u * 8u + to_address.x % 8u, to_entry - 1u);
            const uint to_at = to_place.y * to_frames_extent.x + to_place.x;
            const bool to_found = !(to_entry == 0u) && to_place.y < to_frames_extent.y;
            // transfer.glift:21
            if (to_found) {
                to_frames_data[to_at] = from_data[from_at];
            }
        }
    }
}

static void write_box_bdc9234f_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_bdc9234f_general_rows(call,
        rows); });
}

struct write_box_bdc9234f_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t from_extent_x;
    uint div_ceil_x;
    uint to_table_extent;
    std::uint64_t to_frames_extent_x;
    uint to_frames_extent_y;
    std::uint64_t from_data_address;
    std::uint64_t to_table_data_address;
    std::uint64_t to_frames_data_address;
};
static_assert(offsetof(write_box_bdc9234f_wide_parameters, size) == 0);
static_assert(offsetof(write_box_bdc9234f_wide_parameters, from_origin) == 8);
static_assert(offsetof(write_box_bdc9234f_wide_parameters, to_origin) == 16);
static_assert(offsetof(write_box_bdc9234f_wide_parameters, base) == 24);
static_assert(offsetof(write_box_bdc9234f_wide_parameters, from_extent_x) == 40);
static_assert(offsetof(write_box_bdc9234f_wide_parameters, div_ceil_x) == 48);
static_assert(offsetof(write_box_bdc9234f_wide_parameters, to_table_extent) == 52);
static_assert(offsetof(write_box_bdc9234f_wide_parameters, to_frames_extent_x) == 56);
static_assert(offsetof(write_box_bdc9234f_wide_parameters, to_frames_extent_y) == 64);
static_assert(offsetof(write_box_bdc9234f_wide_parameters, from_data_address) == 72);
static_assert(offsetof(write_box_bdc9234f_wide_parameters, to_table_data_address) == 80);
static_assert(offsetof(write_box_bdc9234f_wide_parameters, to_frames_data_address) == 88);

// transfer.glift:20: write_box<Box<2, float>, Listed>, some rows.
GLIFT_HOST_KERNEL
static void write_box_bdc9234f_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_bdc9234f_wide_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const std::uint64_t from_extent_x = parameters.from_extent_x;
    const uint div_ceil_x = parameters.div_ceil_x;
    const uint to_table_extent = parameters.to_table_extent;
    const std::uint64_t to_frames_extent_x = parameters.to_frames_extent_x;
    const uint to_frames_extent_y = parameters.to_frames_extent_y;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    const uint* to_table_data = glift::host::elements<const uint>(call.memories[1]);
    float* to_frames_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:21
            const uint2 from_address = from_origin + address;
            // transfer.glift:20
            const std::uint64_t from_at = std::uint64_t(from_address.y) * from_extent_x + std::uint64_t(from_address.x);
            // transfer.glift:21
            const uint2 to_address = to_origin + address;
            // transfer.glift:20
            const uint to_table_address = to_address.y / 8u * div_ceil_x + to_address.x / 8u;
            const bool to_table_value_inside = to_table_address < to_table_extent;
            const std::uint64_t to_table_value_at = std::uint64_t(to_table_address);
            const uint to_table_value = to_table_data[to_table_value_inside ? to_table_value_at : std::uint64_t{0u}];
            const uint to_entry = to_table_value_inside ? to_table_value : 0u;
            const uint2 to_place = uint2(to_address.y % 8u * 8u + to_address.x % 8u, to_entry - 1u);
            const std::uint64_t to_at = std::uint64_t(to_place.y) * to_frames_extent_x + std::uint64_t(to_place.x);
            const bool to_found = !(to_entry == 0u) && to_place.y < to_frames_extent_y;
            // transfer.glift:21
            if (to_found) {
                to_frames_data[to_at] = from_data[from_at];
            }
        }
    }
}

static void write_box_bdc9234f_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_bdc9234f_wide_rows(call, rows); });
}

const glift::Binding write_box_bdc9234f_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 72,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "to.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 80,
        .element_bytes = sizeof(uint), .parameter = 1},
    {.name = "to.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 88,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter write_box_bdc9234f_parameters[] = {
    {"from_extent", 0, sizeof(write_box_bdc9234f_direct_parameters::from_extent)},
    {"div_ceil_x", 8, sizeof(write_box_bdc9234f_direct_parameters::div_ceil_x)},
    {"to_table_extent", 12, sizeof(write_box_bdc9234f_direct_parameters::to_table_extent)},
    {"to_frames_extent", 16, sizeof(write_box_bdc9234f_direct_parameters::to_frames_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_bdc9234f_kernel;
const glift::Kernel write_box_bdc9234f_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = write_box_bdc9234f_bindings,
    .direct = {.host = &write_box_bdc9234f_direct, .parameter_bytes = 24, .push_constants = true},
    .general = {.host = &write_box_bdc9234f_general, .parameter_bytes = 44},
    .wide = {.host = &write_box_bdc9234f_wide, .parameter_bytes = 96, .base_offset = 24},
    .parameters = write_box_bdc9234f_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Listed, float>

namespace {
struct fill_box_c2b13d34_direct_parameters {
    uint2 size;
    uint to_active_extent;
    uint div_ceil_x;
    uint div_ceil_x_2;
    uint to_table_extent;
    uint2 to_frames_extent;
    uint2 to_extent;
    float value;
};
static_assert(offsetof(fill_box_c2b13d34_direct_parameters, size) == 0);
static_assert(offsetof(fill_box_c2b13d34_direct_parameters, to_active_extent) == 8);
static_assert(offsetof(fill_box_c2b13d34_direct_parameters, div_ceil_x) == 12);
static_assert(offsetof(fill_box_c2b13d34_direct_parameters, div_ceil_x_2) == 16);
static_assert(offsetof(fill_box_c2b13d34_direct_parameters, to_table_extent) == 20);
static_assert(offsetof(fill_box_c2b13d34_direct_parameters, to_frames_extent) == 24);
static_assert(offsetof(fill_box_c2b13d34_direct_parameters, to_extent) == 32);
static_assert(offsetof(fill_box_c2b13d34_direct_parameters, value) == 40);

// transfer.glift:25: fill_box<Listed, float>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_c2b13d34_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_c2b13d34_direct_parameters*>(call.parameters);
    const uint to_active_extent = parameters.to_active_extent;
    const uint div_ceil_x = parameters.div_ceil_x;
    const uint div_ceil_x_2 = parameters.div_ceil_x_2;
    const uint to_table_extent = parameters.to_table_extent;
    const uint2 to_frames_extent = parameters.to_frames_extent;
    const uint2 to_extent = parameters.to_extent;
    const float value = parameters.value;
    const uint* to_active_data = glift::host::elements<const uint>(call.memories[0]);
    const uint* to_table_data = glift::host::elements<const uint>(call.memories[1]);
    float* to_frames_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        bool is_whole = false;
        {
            const uint2 block_2{row.begin, row.y};
            const bool to_active_value_inside = block_2.y < to_active_extent;
            const uint to_active_value = to_active_data[to_active_value_inside ? block_2.y : 0u];
            const uint rest = to_active_value_inside ? to_active_value : 0u;
            const uint block_x = glift::remainder(rest, div_ceil_x);
            const uint block_y = glift::divide(rest, div_ceil_x);
            // transfer.glift:25
            const uint to_table_address = block_y * div_ceil_x_2 + block_x;
            const bool to_table_value_inside = to_table_address < to_table_extent;
            const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
            const uint to_entry = to_table_value_inside ? to_table_value : 0u;
            const uint to_frames_index = to_entry - 1u;
            is_whole = block_x <= 536870911u && block_y <= 536870911u
                && glift::all(glift::lessThan(uint2(block_x * 8u + 7u, block_y * 8u + 7u), to_extent))
                && (!(to_entry == 0u) && to_frames_index < to_frames_extent.y);
            if (is_whole) {
                if (row.begin < row.end) {
                    const uint2 address{row.begin, row.y};
                    const uint in_block = address.x;
                    // transfer.glift:25
                    const uint to_at = to_frames_index * to_frames_extent.x + in_block;
                    float* to_frames_data_row = glift::host::row_pointer(to_frames_data + to_at);
                    GLIFT_INDEPENDENT
                    for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                        // transfer.glift:26
                        to_frames_data_row[i] = value;
                    }
                }
            }
        }
        if (!is_whole) {
            GLIFT_INDEPENDENT
            for (uint x = row.begin; x < row.end; ++x) {
                const uint2 address{x, row.y};
                const uint in_block = address.x;
                const bool to_active_value_inside = address.y < to_active_extent;
                const uint to_active_value = to_active_data[to_active_value_inside ? address.y : 0u];
                const uint rest = to_active_value_inside ? to_active_value : 0u;
                const uint block_x = glift::remainder(rest, div_ceil_x);
                const uint block_y = glift::divide(rest, div_ceil_x);
                // transfer.glift:25
                const uint to_table_address = block_y * div_ceil_x_2 + block_x;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
                const uint to_entry = to_table_value_inside ? to_table_value : 0u;
                const uint to_frames_index = to_entry - 1u;
                const bool to_found = !(to_entry == 0u) && to_frames_index < to_frames_extent.y;
                if (block_x <= 536870911u && block_y <= 536870911u
                    && glift::all(glift::lessThan(uint2(block_x * 8u + in_block % 8u, block_y * 8u + in_block / 8u),
                    to_extent))) {
                    const uint to_at = to_frames_index * to_frames_extent.x + in_block;
                    // transfer.glift:26
                    if (to_found) {
                        to_frames_data[to_at] = value;
                    }
                }
            }
        }
    }
}

static void fill_box_c2b13d34_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_c2b13d34_direct_rows(call, rows); });
}

struct fill_box_c2b13d34_general_parameters {
    uint2 size;
    uint2 to_size;
    uint2 to_origin;
    uint to_active_extent;
    uint div_ceil_x;
    uint div_ceil_x_2;
    uint to_table_extent;
    uint2 to_frames_extent;
    float value;
};
static_assert(offsetof(fill_box_c2b13d34_general_parameters, size) == 0);
static_assert(offsetof(fill_box_c2b13d34_general_parameters, to_size) == 8);
static_assert(offsetof(fill_box_c2b13d34_general_parameters, to_origin) == 16);
static_assert(offsetof(fill_box_c2b13d34_general_parameters, to_active_extent) == 24);
static_assert(offsetof(fill_box_c2b13d34_general_parameters, div_ceil_x) == 28);
static_assert(offsetof(fill_box_c2b13d34_general_parameters, div_ceil_x_2) == 32);
static_assert(offsetof(fill_box_c2b13d34_general_parameters, to_table_extent) == 36);
static_assert(offsetof(fill_box_c2b13d34_general_parameters, to_frames_extent) == 40);
static_assert(offsetof(fill_box_c2b13d34_general_parameters, value) == 48);

// transfer.glift:25: fill_box<Listed, float>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_c2b13d34_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_c2b13d34_general_parameters*>(call.parameters);
    const uint2 to_size = parameters.to_size;
    const uint2 to_origin = parameters.to_origin;
    const uint to_active_extent = parameters.to_active_extent;
    const uint div_ceil_x = parameters.div_ceil_x;
    const uint div_ceil_x_2 = parameters.div_ceil_x_2;
    const uint to_table_extent = parameters.to_table_extent;
    const uint2 to_frames_extent = parameters.to_frames_extent;
    const float value = parameters.value;
    const uint* to_active_data = glift::host::elements<const uint>(call.memories[0]);
    const uint* to_table_data = glift::host::elements<const uint>(call.memories[1]);
    float* to_frames_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        bool is_whole = false;
        {
            const uint2 block_2{row.begin, row.y};
            const bool to_active_value_inside = block_2.y < to_active_extent;
            const uint to_active_value = to_active_data[to_active_value_inside ? block_2.y : 0u];
            const uint rest = to_active_value_inside ? to_active_value : 0u;
            const uint block_x = glift::remainder(rest, div_ceil_x);
            const uint block_y = glift::divide(rest, div_ceil_x);
            // transfer.glift:25
            const uint to_table_address = block_y * div_ceil_x_2 + block_x;
            const bool to_table_value_inside = to_table_address < to_table_extent;
            const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
            const uint to_entry = to_table_value_inside ? to_table_value : 0u;
            const uint to_frames_index = to_entry - 1u;
            const uint2 value_2 = uint2(block_x * 8u + 7u, block_y * 8u + 7u) - to_origin;
            is_whole = block_x <= 536870911u && block_y <= 536870911u
                && (glift::all(glift::lessThan(value_2 - uint2(7u, 7u), to_size))
                && glift::all(glift::lessThan(value_2, to_size)))
                && (!(to_entry == 0u) && to_frames_index < to_frames_extent.y);
            if (is_whole) {
                if (row.begin < row.end) {
                    const uint2 address{row.begin, row.y};
                    const uint in_block = address.x;
                    // transfer.glift:25
                    const uint to_at = to_frames_index * to_frames_extent.x + in_block;
                    float* to_frames_data_row = glift::host::row_pointer(to_frames_data + to_at);
                    GLIFT_INDEPENDENT
                    for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                        // transfer.glift:26
                        to_frames_data_row[i] = value;
                    }
                }
            }
        }
        if (!is_whole) {
            GLIFT_INDEPENDENT
            for (uint x = row.begin; x < row.end; ++x) {
                const uint2 address{x, row.y};
                const uint in_block = address.x;
                const bool to_active_value_inside = address.y < to_active_extent;
                const uint to_active_value = to_active_data[to_active_value_inside ? address.y : 0u];
                const uint rest = to_active_value_inside ? to_active_value : 0u;
                const uint block_x = glift::remainder(rest, div_ceil_x);
                const uint block_y = glift::divide(rest, div_ceil_x);
                // transfer.glift:25
                const uint to_table_address = block_y * div_ceil_x_2 + block_x;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
                const uint to_entry = to_table_value_inside ? to_table_value : 0u;
                const uint to_frames_index = to_entry - 1u;
                const bool to_found = !(to_entry == 0u) && to_frames_index < to_frames_extent.y;
                if (block_x <= 536870911u && block_y <= 536870911u
                    && glift::all(glift::lessThan(uint2(block_x * 8u + in_block % 8u, block_y * 8u
                    + in_block / 8u) - to_origin, to_size))) {
                    const uint to_at = to_frames_index * to_frames_extent.x + in_block;
                    // transfer.glift:26
                    if (to_found) {
                        to_frames_data[to_at] = value;
                    }
                }
            }
        }
    }
}

static void fill_box_c2b13d34_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_c2b13d34_general_rows(call,
        rows); });
}

struct fill_box_c2b13d34_wide_parameters {
    uint2 size;
    uint2 to_size;
    uint2 to_origin;
    uint to_active_extent;
    uint div_ceil_x;
    uint div_ceil_x_2;
    uint to_table_extent;
    uint to_frames_extent_y;
    std::uint64_t to_frames_extent_x;
    float value;
    std::uint64_t to_active_data_address;
    std::uint64_t to_table_data_address;
    std::uint64_t to_frames_data_address;
};
static_assert(offsetof(fill_box_c2b13d34_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_c2b13d34_wide_parameters, to_size) == 8);
static_assert(offsetof(fill_box_c2b13d34_wide_parameters, to_origin) == 16);
static_assert(offsetof(fill_box_c2b13d34_wide_parameters, to_active_extent) == 24);
static_assert(offsetof(fill_box_c2b13d34_wide_parameters, div_ceil_x) == 28);
static_assert(offsetof(fill_box_c2b13d34_wide_parameters, div_ceil_x_2) == 32);
static_assert(offsetof(fill_box_c2b13d34_wide_parameters, to_table_extent) == 36);
static_assert(offsetof(fill_box_c2b13d34_wide_parameters, to_frames_extent_y) == 40);
static_assert(offsetof(fill_box_c2b13d34_wide_parameters, to_frames_extent_x) == 48);
static_assert(offsetof(fill_box_c2b13d34_wide_parameters, value) == 56);
static_assert(offsetof(fill_box_c2b13d34_wide_parameters, to_active_data_address) == 64);
static_assert(offsetof(fill_box_c2b13d34_wide_parameters, to_table_data_address) == 72);
static_assert(offsetof(fill_box_c2b13d34_wide_parameters, to_frames_data_address) == 80);

// transfer.glift:25: fill_box<Listed, float>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_c2b13d34_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_c2b13d34_wide_parameters*>(call.parameters);
    const uint2 to_size = parameters.to_size;
    const uint2 to_origin = parameters.to_origin;
    const uint to_active_extent = parameters.to_active_extent;
    const uint div_ceil_x = parameters.div_ceil_x;
    const uint div_ceil_x_2 = parameters.div_ceil_x_2;
    const uint to_table_extent = parameters.to_table_extent;
    const uint to_frames_extent_y = parameters.to_frames_extent_y;
    const std::uint64_t to_frames_extent_x = parameters.to_frames_extent_x;
    const float value = parameters.value;
    const uint* to_active_data = glift::host::elements<const uint>(call.memories[0]);
    const uint* to_table_data = glift::host::elements<const uint>(call.memories[1]);
    float* to_frames_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        bool is_whole = false;
        {
            const uint2 block_2{row.begin, row.y};
            const bool to_active_value_inside = block_2.y < to_active_extent;
            const std::uint64_t to_active_value_at = std::uint64_t(block_2.y);
            const uint to_active_value = to_active_data[to_active_value_inside ? to_active_value_at
                : std::uint64_t{0u}];
            const uint rest = to_active_value_inside ? to_active_value : 0u;
            const uint block_x = glift::remainder(rest, div_ceil_x);
            const uint block_y = glift::divide(rest, div_ceil_x);
            // transfer.glift:25
            const uint to_table_address = block_y * div_ceil_x_2 + block_x;
            const bool to_table_value_inside = to_table_address < to_table_extent;
            const std::uint64_t to_table_value_at = std::uint64_t(to_table_address);
            const uint to_table_value = to_table_data[to_table_value_inside ? to_table_value_at : std::uint64_t{0u}];
            const uint to_entry = to_table_value_inside ? to_table_value : 0u;
            const uint value_2 = to_entry - 1u;
            const uint2 value_3 = uint2(block_x * 8u + 7u, block_y * 8u + 7u) - to_origin;
            is_whole = block_x <= 536870911u && block_y <= 536870911u
                && (glift::all(glift::lessThan(value_3 - uint2(7u, 7u), to_size))
                && glift::all(glift::lessThan(value_3, to_size)))
                && (!(to_entry == 0u) && value_2 < to_frames_extent_y);
            if (is_whole) {
                GLIFT_INDEPENDENT
                for (uint x = row.begin; x < row.end; ++x) {
                    const uint2 address{x, row.y};
                    const uint in_block = address.x;
                    // transfer.glift:25
                    const std::uint64_t to_at = std::uint64_t(value_2) * to_frames_extent_x + std::uint64_t(in_block);
                    // transfer.glift:26
                    to_frames_data[to_at] = value;
                }
            }
        }
        if (!is_whole) {
            GLIFT_INDEPENDENT
            for (uint x = row.begin; x < row.end; ++x) {
                const uint2 address{x, row.y};
                const uint in_block = address.x;
                const bool to_active_value_inside = address.y < to_active_extent;
                const std::uint64_t to_active_value_at = std::uint64_t(address.y);
                const uint to_active_value = to_active_data[to_active_value_inside ? to_active_value_at
                    : std::uint64_t{0u}];
                const uint rest = to_active_value_inside ? to_active_value : 0u;
                const uint block_x = glift::remainder(rest, div_ceil_x);
                const uint block_y = glift::divide(rest, div_ceil_x);
                // transfer.glift:25
                const uint to_table_address = block_y * div_ceil_x_2 + block_x;
                const bool to_table_value_inside = to_table_address < to_table_extent;
                const std::uint64_t to_table_value_at = std::uint64_t(to_table_address);
                const uint to_table_value = to_table_data[to_table_value_inside ? to_table_value_at
                    : std::uint64_t{0u}];
                const uint to_entry = to_table_value_inside ? to_table_value : 0u;
                const uint value_2 = to_entry - 1u;
                const bool to_found = !(to_entry == 0u) && value_2 < to_frames_extent_y;
                if (block_x <= 536870911u && block_y <= 536870911u
                    && glift::all(glift::lessThan(uint2(block_x * 8u + in_block % 8u, block_y * 8u
                    + in_block / 8u) - to_origin, to_size))) {
                    const std::uint64_t to_at = std::uint64_t(value_2) * to_frames_extent_x + std::uint64_t(in_block);
                    // transfer.glift:26
                    if (to_found) {
                        to_frames_data[to_at] = value;
                    }
                }
            }
        }
    }
}

static void fill_box_c2b13d34_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_c2b13d34_wide_rows(call, rows); });
}

const glift::Binding fill_box_c2b13d34_bindings[] = {
    {.name = "to.active.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 64,
        .element_bytes = sizeof(uint)},
    {.name = "to.table.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 72,
        .element_bytes = sizeof(uint)},
    {.name = "to.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 80,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
};
constexpr glift::Parameter fill_box_c2b13d34_parameters[] = {
    {"size", 0, sizeof(fill_box_c2b13d34_direct_parameters::size)},
    {"to_active_extent", 8, sizeof(fill_box_c2b13d34_direct_parameters::to_active_extent)},
    {"div_ceil_x", 12, sizeof(fill_box_c2b13d34_direct_parameters::div_ceil_x)},
    {"div_ceil_x_2", 16, sizeof(fill_box_c2b13d34_direct_parameters::div_ceil_x_2)},
    {"to_table_extent", 20, sizeof(fill_box_c2b13d34_direct_parameters::to_table_extent)},
    {"to_frames_extent", 24, sizeof(fill_box_c2b13d34_direct_parameters::to_frames_extent)},
    {"to_extent", 32, sizeof(fill_box_c2b13d34_direct_parameters::to_extent)},
    {"value", 40, sizeof(fill_box_c2b13d34_direct_parameters::value)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_c2b13d34_kernel;
const glift::Kernel fill_box_c2b13d34_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 2,
    .group = {64, 1, 1},
    .loop_rounds = 0,
    .bindings = fill_box_c2b13d34_bindings,
    .direct = {.host = &fill_box_c2b13d34_direct, .parameter_bytes = 44},
    .general = {.host = &fill_box_c2b13d34_general, .parameter_bytes = 52},
    .wide = {.host = &fill_box_c2b13d34_wide, .parameter_bytes = 88},
    .parameters = fill_box_c2b13d34_parameters,
    .of_blocks = true,
};

}  // namespace std_transfer

