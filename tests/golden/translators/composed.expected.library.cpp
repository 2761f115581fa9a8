// Made by gliftc from composed.glift. Changes are lost when it is made again.
#include "composed.glift.internal.hpp"

#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>

#include <optional>

namespace std_transfer {

using namespace glift::types;

namespace {

// address.glift:18: volume<2> in 64 bits
inline std::uint64_t volume_64(uint2 extent) {
    // address.glift:19
    std::uint64_t product = std::uint64_t(extent.x);
    // address.glift:20
    for (uint axis = 1u; axis < 2u; ++axis) {
        // address.glift:21
        product = glift::saturated_product(product, std::uint64_t(extent[axis]));
    }
    // address.glift:23
    return product;
}

// address.glift:27: linearize<2> in 64 bits
inline std::uint64_t linearize_64(uint2 address, uint2 extent) {
    // address.glift:28
    std::uint64_t index = std::uint64_t(address.y);
    // address.glift:29
    for (uint back = 1u; back < 2u; ++back) {
        // address.glift:30
        index = index * std::uint64_t(extent[2u - 1u - back]) + std::uint64_t(address[2u - 1u - back]);
    }
    // address.glift:32
    return index;
}

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Turned, Box<2, float>>

struct read_box_fa044b2c_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_fa044b2c_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_fa044b2c_direct_parameters, to_extent_x) == 8);

// transfer.glift:15: read_box<Turned, Box<2, float>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_fa044b2c_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_fa044b2c_direct_parameters*>(call.parameters);
    const uint2 from_extent = parameters.from_extent;
    const uint to_extent_x = parameters.to_extent_x;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
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
                const uint from_at = address.x * from_extent.y + address.y;
                // transfer.glift:16
                to_data_row[i] = from_data[from_at];
            }
        }
    }
}

static void read_box_fa044b2c_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_fa044b2c_direct_rows(call, rows); });
}

struct read_box_fa044b2c_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_y;
    uint to_extent_x;
};
static_assert(offsetof(read_box_fa044b2c_general_parameters, size) == 0);
static_assert(offsetof(read_box_fa044b2c_general_parameters, from_origin) == 8);
static_assert(offsetof(read_box_fa044b2c_general_parameters, to_origin) == 16);
static_assert(offsetof(read_box_fa044b2c_general_parameters, from_extent_y) == 24);
static_assert(offsetof(read_box_fa044b2c_general_parameters, to_extent_x) == 28);

// transfer.glift:15: read_box<Turned, Box<2, float>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_fa044b2c_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_fa044b2c_general_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const uint from_extent_y = parameters.from_extent_y;
    const uint to_extent_x = parameters.to_extent_x;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
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
                const uint from_at = from_address.x * from_extent_y + from_address.y;
                // transfer.glift:16
                to_data_row[i] = from_data[from_at];
            }
        }
    }
}

static void read_box_fa044b2c_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_fa044b2c_general_rows(call,
        rows); });
}

struct read_box_fa044b2c_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t from_extent_y;
    std::uint64_t to_extent_x;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_fa044b2c_wide_parameters, size) == 0);
static_assert(offsetof(read_box_fa044b2c_wide_parameters, from_origin) == 8);
static_assert(offsetof(read_box_fa044b2c_wide_parameters, to_origin) == 16);
static_assert(offsetof(read_box_fa044b2c_wide_parameters, base) == 24);
static_assert(offsetof(read_box_fa044b2c_wide_parameters, from_extent_y) == 40);
static_assert(offsetof(read_box_fa044b2c_wide_parameters, to_extent_x) == 48);
static_assert(offsetof(read_box_fa044b2c_wide_parameters, from_data_address) == 56);
static_assert(offsetof(read_box_fa044b2c_wide_parameters, to_data_address) == 64);

// transfer.glift:15: read_box<Turned, Box<2, float>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_fa044b2c_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_fa044b2c_wide_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const std::uint64_t from_extent_y = parameters.from_extent_y;
    const std::uint64_t to_extent_x = parameters.to_extent_x;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:16
            const uint2 from_address = from_origin + address;
            // transfer.glift:15
            const std::uint64_t from_at = std::uint64_t(from_address.x) * from_extent_y + std::uint64_t(from_address.y);
            // transfer.glift:16
            const uint2 to_address = to_origin + address;
            // transfer.glift:15
            const std::uint64_t to_at = std::uint64_t(to_address.y) * to_extent_x + std::uint64_t(to_address.x);
            // transfer.glift:16
            to_data[to_at] = from_data[from_at];
        }
    }
}

static void read_box_fa044b2c_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_fa044b2c_wide_rows(call, rows); });
}

const glift::Binding read_box_fa044b2c_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 56,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 64,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter read_box_fa044b2c_parameters[] = {
    {"from_extent", 0, sizeof(read_box_fa044b2c_direct_parameters::from_extent)},
    {"to_extent_x", 8, sizeof(read_box_fa044b2c_direct_parameters::to_extent_x)},
};
const glift::Kernel read_box_fa044b2c_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = read_box_fa044b2c_bindings,
    .direct = {.host = &read_box_fa044b2c_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &read_box_fa044b2c_general, .parameter_bytes = 32},
    .wide = {.host = &read_box_fa044b2c_wide, .parameter_bytes = 72, .base_offset = 24},
    .parameters = read_box_fa044b2c_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<2, float>, Turned>

struct write_box_1eb09855_direct_parameters {
    uint2 from_extent;
    uint to_extent_y;
};
static_assert(offsetof(write_box_1eb09855_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_1eb09855_direct_parameters, to_extent_y) == 8);

// transfer.glift:20: write_box<Box<2, float>, Turned>, some rows.
GLIFT_HOST_KERNEL
static void write_box_1eb09855_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_1eb09855_direct_parameters*>(call.parameters);
    const uint2 from_extent = parameters.from_extent;
    const uint to_extent_y = parameters.to_extent_y;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:20
            const uint from_at = address.y * from_extent.x + address.x;
            const float* from_data_row = glift::host::row_pointer(from_data + from_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint2 address{row.begin + static_cast<uint>(i), row.y};
                // transfer.glift:20
                const uint to_at = address.x * to_extent_y + address.y;
                // transfer.glift:21
                to_data[to_at] = from_data_row[i];
            }
        }
    }
}

static void write_box_1eb09855_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_1eb09855_direct_rows(call,
        rows); });
}

struct write_box_1eb09855_general_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint from_extent_x;
    uint to_extent_y;
};
static_assert(offsetof(write_box_1eb09855_general_parameters, size) == 0);
static_assert(offsetof(write_box_1eb09855_general_parameters, from_origin) == 8);
static_assert(offsetof(write_box_1eb09855_general_parameters, to_origin) == 16);
static_assert(offsetof(write_box_1eb09855_general_parameters, from_extent_x) == 24);
static_assert(offsetof(write_box_1eb09855_general_parameters, to_extent_y) == 28);

// transfer.glift:20: write_box<Box<2, float>, Turned>, some rows.
GLIFT_HOST_KERNEL
static void write_box_1eb09855_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_1eb09855_general_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const uint from_extent_x = parameters.from_extent_x;
    const uint to_extent_y = parameters.to_extent_y;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint2 address{row.begin, row.y};
            // transfer.glift:21
            const uint2 from_address = from_origin + address;
            // transfer.glift:20
            const uint from_at = from_address.y * from_extent_x + from_address.x;
            const float* from_data_row = glift::host::row_pointer(from_data + from_at);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint2 address{row.begin + static_cast<uint>(i), row.y};
                // transfer.glift:21
                const uint2 to_address = to_origin + address;
                // transfer.glift:20
                const uint to_at = to_address.x * to_extent_y + to_address.y;
                // transfer.glift:21
                to_data[to_at] = from_data_row[i];
            }
        }
    }
}

static void write_box_1eb09855_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_1eb09855_general_rows(call,
        rows); });
}

struct write_box_1eb09855_wide_parameters {
    uint2 size;
    uint2 from_origin;
    uint2 to_origin;
    uint3 base;
    std::uint64_t from_extent_x;
    std::uint64_t to_extent_y;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(write_box_1eb09855_wide_parameters, size) == 0);
static_assert(offsetof(write_box_1eb09855_wide_parameters, from_origin) == 8);
static_assert(offsetof(write_box_1eb09855_wide_parameters, to_origin) == 16);
static_assert(offsetof(write_box_1eb09855_wide_parameters, base) == 24);
static_assert(offsetof(write_box_1eb09855_wide_parameters, from_extent_x) == 40);
static_assert(offsetof(write_box_1eb09855_wide_parameters, to_extent_y) == 48);
static_assert(offsetof(write_box_1eb09855_wide_parameters, from_data_address) == 56);
static_assert(offsetof(write_box_1eb09855_wide_parameters, to_data_address) == 64);

// transfer.glift:20: write_box<Box<2, float>, Turned>, some rows.
GLIFT_HOST_KERNEL
static void write_box_1eb09855_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_1eb09855_wide_parameters*>(call.parameters);
    const uint2 from_origin = parameters.from_origin;
    const uint2 to_origin = parameters.to_origin;
    const std::uint64_t from_extent_x = parameters.from_extent_x;
    const std::uint64_t to_extent_y = parameters.to_extent_y;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
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
            const std::uint64_t to_at = std::uint64_t(to_address.x) * to_extent_y + std::uint64_t(to_address.y);
            // transfer.glift:21
            to_data[to_at] = from_data[from_at];
        }
    }
}

static void write_box_1eb09855_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_1eb09855_wide_rows(call, rows); });
}

const glift::Binding write_box_1eb09855_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 56,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 64,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter write_box_1eb09855_parameters[] = {
    {"from_extent", 0, sizeof(write_box_1eb09855_direct_parameters::from_extent)},
    {"to_extent_y", 8, sizeof(write_box_1eb09855_direct_parameters::to_extent_y)},
};
const glift::Kernel write_box_1eb09855_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = write_box_1eb09855_bindings,
    .direct = {.host = &write_box_1eb09855_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &write_box_1eb09855_general, .parameter_bytes = 32},
    .wide = {.host = &write_box_1eb09855_wide, .parameter_bytes = 72, .base_offset = 24},
    .parameters = write_box_1eb09855_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Turned, float>

struct fill_box_composed_Turned_float_direct_parameters {
    uint2 to_extent;
    float value;
};
static_assert(offsetof(fill_box_composed_Turned_float_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_composed_Turned_float_direct_parameters, value) == 8);

// transfer.glift:25: fill_box<Turned, float>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_composed_Turned_float_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_composed_Turned_float_direct_parameters*>(call.parameters);
    const uint2 to_extent = parameters.to_extent;
    const float value = parameters.value;
    float* to_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:25
            const uint to_at = address.x * to_extent.y + address.y;
            // transfer.glift:26
            to_data[to_at] = value;
        }
    }
}

static void fill_box_composed_Turned_float_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_composed_Turned_float_direct_rows(call, rows); });
}

struct fill_box_composed_Turned_float_general_parameters {
    uint2 size;
    uint2 to_origin;
    uint to_extent_y;
    float value;
};
static_assert(offsetof(fill_box_composed_Turned_float_general_parameters, size) == 0);
static_assert(offsetof(fill_box_composed_Turned_float_general_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_composed_Turned_float_general_parameters, to_extent_y) == 16);
static_assert(offsetof(fill_box_composed_Turned_float_general_parameters, value) == 20);

// transfer.glift:25: fill_box<Turned, float>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_composed_Turned_float_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_composed_Turned_float_general_parameters*>(call.parameters);
    const uint2 to_origin = parameters.to_origin;
    const uint to_extent_y = parameters.to_extent_y;
    const float value = parameters.value;
    float* to_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:26
            const uint2 to_address = to_origin + address;
            // transfer.glift:25
            const uint to_at = to_address.x * to_extent_y + to_address.y;
            // transfer.glift:26
            to_data[to_at] = value;
        }
    }
}

static void fill_box_composed_Turned_float_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_composed_Turned_float_general_rows(call, rows); });
}

struct fill_box_composed_Turned_float_wide_parameters {
    uint2 size;
    uint2 to_origin;
    uint3 base;
    std::uint64_t to_extent_y;
    float value;
    std::uint64_t to_data_address;
};
static_assert(offsetof(fill_box_composed_Turned_float_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_composed_Turned_float_wide_parameters, to_origin) == 8);
static_assert(offsetof(fill_box_composed_Turned_float_wide_parameters, base) == 16);
static_assert(offsetof(fill_box_composed_Turned_float_wide_parameters, to_extent_y) == 32);
static_assert(offsetof(fill_box_composed_Turned_float_wide_parameters, value) == 40);
static_assert(offsetof(fill_box_composed_Turned_float_wide_parameters, to_data_address) == 48);

// transfer.glift:25: fill_box<Turned, float>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_composed_Turned_float_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_composed_Turned_float_wide_parameters*>(call.parameters);
    const uint2 to_origin = parameters.to_origin;
    const std::uint64_t to_extent_y = parameters.to_extent_y;
    const float value = parameters.value;
    float* to_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint2 address{x, row.y};
            // transfer.glift:26
            const uint2 to_address = to_origin + address;
            // transfer.glift:25
            const std::uint64_t to_at = std::uint64_t(to_address.x) * to_extent_y + std::uint64_t(to_address.y);
            // transfer.glift:26
            to_data[to_at] = value;
        }
    }
}

static void fill_box_composed_Turned_float_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_composed_Turned_float_wide_rows(call,
        rows); });
}

const glift::Binding fill_box_composed_Turned_float_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 48,
        .element_bytes = sizeof(float)},
};
constexpr glift::Parameter fill_box_composed_Turned_float_parameters[] = {
    {"to_extent", 0, sizeof(fill_box_composed_Turned_float_direct_parameters::to_extent)},
    {"value", 8, sizeof(fill_box_composed_Turned_float_direct_parameters::value)},
};
const glift::Kernel fill_box_composed_Turned_float_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 2,
    .group = {32, 8, 1},
    .loop_rounds = 0,
    .bindings = fill_box_composed_Turned_float_bindings,
    .direct = {.host = &fill_box_composed_Turned_float_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &fill_box_composed_Turned_float_general, .parameter_bytes = 24},
    .wide = {.host = &fill_box_composed_Turned_float_wide, .parameter_bytes = 56, .base_offset = 16},
    .parameters = fill_box_composed_Turned_float_parameters,
    .items = {1, 2, 1},
};

}  // namespace

GLIFT_SHARED void read_box_fa044b2c(const glift::Commands& commands, const glift::Range<::composed::Turned>& from,
    const glift::Range<Box_2_float>& to) {
    glift::Iteration iteration(read_box_fa044b2c_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(read_box_fa044b2c_kernel, memories, iteration.size())) {
        const read_box_fa044b2c_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .from_extent_y = std::uint64_t(from->extent().y),
            .to_extent_x = std::uint64_t(to->extent().x),
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(read_box_fa044b2c_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_fa044b2c_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const read_box_fa044b2c_direct_parameters parameters = {
            .from_extent = from->extent(),
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_fa044b2c_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const read_box_fa044b2c_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent_y = from->extent().y,
            .to_extent_x = to->extent().x,
        };
        commands.dispatch(read_box_fa044b2c_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(read_box_fa044b2c_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

GLIFT_SHARED void write_box_1eb09855(const glift::Commands& commands, const glift::Range<Box_2_float>& from,
    const glift::Range<::composed::Turned>& to) {
    glift::Iteration iteration(write_box_1eb09855_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(write_box_1eb09855_kernel, memories, iteration.size())) {
        const write_box_1eb09855_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .base = {},
            .from_extent_x = std::uint64_t(from->extent().x),
            .to_extent_y = std::uint64_t(to->extent().y),
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(write_box_1eb09855_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_1eb09855_wide_parameters,
            size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const write_box_1eb09855_direct_parameters parameters = {
            .from_extent = from->extent(),
            .to_extent_y = to->extent().y,
        };
        commands.dispatch(write_box_1eb09855_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const write_box_1eb09855_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_extent_x = from->extent().x,
            .to_extent_y = to->extent().y,
        };
        commands.dispatch(write_box_1eb09855_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(write_box_1eb09855_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

GLIFT_SHARED void fill_box_composed_Turned_float(const glift::Commands& commands,
    const glift::Range<::composed::Turned>& to, float value) {
    glift::Iteration iteration(fill_box_composed_Turned_float_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(fill_box_composed_Turned_float_kernel, memories, iteration.size())) {
        const fill_box_composed_Turned_float_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .base = {},
            .to_extent_y = std::uint64_t(to->extent().y),
            .value = value,
            .to_data_address = 0u,
        };
        commands.dispatch(fill_box_composed_Turned_float_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_composed_Turned_float_wide_parameters, size)})});
    } else if (iteration.is_whole()) {
        const fill_box_composed_Turned_float_direct_parameters parameters = {
            .to_extent = to->extent(),
            .value = value,
        };
        commands.dispatch(fill_box_composed_Turned_float_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const fill_box_composed_Turned_float_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .to_extent_y = to->extent().y,
            .value = value,
        };
        commands.dispatch(fill_box_composed_Turned_float_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(fill_box_composed_Turned_float_general_parameters, size)})});
    }
}

GLIFT_SHARED Box_2_float::Box_2_float(const glift::Commands& commands, uint2 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.allocate({.name = "Box<2, float>.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

GLIFT_SHARED Box_2_float::Box_2_float(const glift::Commands& commands, uint2 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume_64(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Box<2, float>.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

GLIFT_SHARED uint2 Box_2_float::domain() const {
    return extent_;
}

GLIFT_SHARED bool Box_2_float::same_state(const Box_2_float& other) const {
    return extent_ == other.extent_;
}

GLIFT_SHARED std::uint64_t Box_2_float::place(uint2 address) const {
    [[maybe_unused]] const uint2 extent = extent_;
    const auto translate = [&](uint2 va) -> std::uint64_t {
        // linear.glift:12
        return linearize_64(va, extent);
    };
    return translate(address);
}

}  // namespace std_transfer

