// Made by gliftc from composed.glift. Changes are lost when it is made again.
#include "composed.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace std_transfer {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Turned, Box<2, float>>

namespace {
struct read_box_fa044b2c_direct_parameters {
    uint2 from_extent;
    uint to_extent_x;
};
static_assert(offsetof(read_box_fa044b2c_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_fa044b2c_direct_parameters, to_extent_x) == 8);

// transfer.glift:15: runs kernel read_box<Turned, Box<2, float>> for the given rows.
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

// transfer.glift:15: runs kernel read_box<Turned, Box<2, float>> for the given rows.
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

// transfer.glift:15: runs kernel read_box<Turned, Box<2, float>> for the given rows.
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
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_fa044b2c_kernel;
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

namespace {
struct write_box_1eb09855_direct_parameters {
    uint2 from_extent;
    uint to_extent_y;
};
static_assert(offsetof(write_box_1eb09855_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_1eb09855_direct_parameters, to_extent_y) == 8);

// transfer.glift:20: runs kernel write_box<Box<2, float>, Turned> for the given rows.
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

// transfer.glift:20: runs kernel write_box<Box<2, float>, Turned> for the given rows.
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

// transfer.glift:20: runs kernel write_box<Box<2, float>, Turned> for the given rows.
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
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_1eb09855_kernel;
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

namespace {
struct fill_box_composed_Turned_float_direct_parameters {
    uint2 to_extent;
    float value;
};
static_assert(offsetof(fill_box_composed_Turned_float_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_composed_Turned_float_direct_parameters, value) == 8);

// transfer.glift:25: runs kernel fill_box<Turned, float> for the given rows.
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

// transfer.glift:25: runs kernel fill_box<Turned, float> for the given rows.
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

// transfer.glift:25: runs kernel fill_box<Turned, float> for the given rows.
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
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_composed_Turned_float_kernel;
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

}  // namespace std_transfer

