// Made by gliftc from near.glift. Changes are lost when it is made again.
#include "near.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace std_transfer {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Array<3, float, none, buffer>, Box<3, float>>

namespace {
struct read_box_6d963c25_direct_parameters {
    uint3 from_extent;
    uint3 to_extent;
};
static_assert(offsetof(read_box_6d963c25_direct_parameters, from_extent) == 0);
static_assert(offsetof(read_box_6d963c25_direct_parameters, to_extent) == 12);

// transfer.glift:15: runs kernel read_box<Array<3, float, none, buffer>, Box<3, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_6d963c25_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_6d963c25_direct_parameters*>(call.parameters);
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

static void read_box_6d963c25_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_6d963c25_direct_rows(call, rows); });
}

struct read_box_6d963c25_general_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 from_extent;
    uint3 to_extent;
};
static_assert(offsetof(read_box_6d963c25_general_parameters, size) == 0);
static_assert(offsetof(read_box_6d963c25_general_parameters, from_origin) == 12);
static_assert(offsetof(read_box_6d963c25_general_parameters, to_origin) == 24);
static_assert(offsetof(read_box_6d963c25_general_parameters, from_extent) == 36);
static_assert(offsetof(read_box_6d963c25_general_parameters, to_extent) == 48);

// transfer.glift:15: runs kernel read_box<Array<3, float, none, buffer>, Box<3, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_6d963c25_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_6d963c25_general_parameters*>(call.parameters);
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

static void read_box_6d963c25_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_6d963c25_general_rows(call,
        rows); });
}

struct read_box_6d963c25_wide_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 base;
    std::uint64_t from_extent_y;
    std::uint64_t from_extent_x;
    std::uint64_t to_extent_y;
    std::uint64_t to_extent_x;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_6d963c25_wide_parameters, size) == 0);
static_assert(offsetof(read_box_6d963c25_wide_parameters, from_origin) == 12);
static_assert(offsetof(read_box_6d963c25_wide_parameters, to_origin) == 24);
static_assert(offsetof(read_box_6d963c25_wide_parameters, base) == 36);
static_assert(offsetof(read_box_6d963c25_wide_parameters, from_extent_y) == 48);
static_assert(offsetof(read_box_6d963c25_wide_parameters, from_extent_x) == 56);
static_assert(offsetof(read_box_6d963c25_wide_parameters, to_extent_y) == 64);
static_assert(offsetof(read_box_6d963c25_wide_parameters, to_extent_x) == 72);
static_assert(offsetof(read_box_6d963c25_wide_parameters, from_data_address) == 80);
static_assert(offsetof(read_box_6d963c25_wide_parameters, to_data_address) == 88);

// transfer.glift:15: runs kernel read_box<Array<3, float, none, buffer>, Box<3, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_6d963c25_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_6d963c25_wide_parameters*>(call.parameters);
    const uint3 from_origin = parameters.from_origin;
    const uint3 to_origin = parameters.to_origin;
    const std::uint64_t from_extent_y = parameters.from_extent_y;
    const std::uint64_t from_extent_x = parameters.from_extent_x;
    const std::uint64_t to_extent_y = parameters.to_extent_y;
    const std::uint64_t to_extent_x = parameters.to_extent_x;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint3 address{x, row.y, row.z};
            // transfer.glift:16
            const uint3 from_address = from_origin + address;
            // transfer.glift:15
            const std::uint64_t from_at = (std::uint64_t(from_address.z) * from_extent_y
                + std::uint64_t(from_address.y)) * from_extent_x + std::uint64_t(from_address.x);
            // transfer.glift:16
            const uint3 to_address = to_origin + address;
            // transfer.glift:15
            const std::uint64_t to_at = (std::uint64_t(to_address.z) * to_extent_y
                + std::uint64_t(to_address.y)) * to_extent_x + std::uint64_t(to_address.x);
            // transfer.glift:16
            to_data[to_at] = from_data[from_at];
        }
    }
}

static void read_box_6d963c25_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_6d963c25_wide_rows(call, rows); });
}

const glift::Binding read_box_6d963c25_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 80,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 88,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter read_box_6d963c25_parameters[] = {
    {"from_extent", 0, sizeof(read_box_6d963c25_direct_parameters::from_extent)},
    {"to_extent", 12, sizeof(read_box_6d963c25_direct_parameters::to_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_6d963c25_kernel;
const glift::Kernel read_box_6d963c25_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 3,
    .group = {32, 4, 2},
    .loop_rounds = 0,
    .bindings = read_box_6d963c25_bindings,
    .direct = {.host = &read_box_6d963c25_direct, .parameter_bytes = 24, .push_constants = true},
    .general = {.host = &read_box_6d963c25_general, .parameter_bytes = 60},
    .wide = {.host = &read_box_6d963c25_wide, .parameter_bytes = 96, .base_offset = 36},
    .parameters = read_box_6d963c25_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<3, float>, Array<3, float, none, buffer>>

namespace {
struct write_box_e5b112ea_direct_parameters {
    uint3 from_extent;
    uint3 to_extent;
};
static_assert(offsetof(write_box_e5b112ea_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_e5b112ea_direct_parameters, to_extent) == 12);

// transfer.glift:20: runs kernel write_box<Box<3, float>, Array<3, float, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_e5b112ea_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_e5b112ea_direct_parameters*>(call.parameters);
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

static void write_box_e5b112ea_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_e5b112ea_direct_rows(call,
        rows); });
}

struct write_box_e5b112ea_general_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 from_extent;
    uint3 to_extent;
};
static_assert(offsetof(write_box_e5b112ea_general_parameters, size) == 0);
static_assert(offsetof(write_box_e5b112ea_general_parameters, from_origin) == 12);
static_assert(offsetof(write_box_e5b112ea_general_parameters, to_origin) == 24);
static_assert(offsetof(write_box_e5b112ea_general_parameters, from_extent) == 36);
static_assert(offsetof(write_box_e5b112ea_general_parameters, to_extent) == 48);

// transfer.glift:20: runs kernel write_box<Box<3, float>, Array<3, float, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_e5b112ea_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_e5b112ea_general_parameters*>(call.parameters);
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

static void write_box_e5b112ea_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_e5b112ea_general_rows(call,
        rows); });
}

struct write_box_e5b112ea_wide_parameters {
    uint3 size;
    uint3 from_origin;
    uint3 to_origin;
    uint3 base;
    std::uint64_t from_extent_y;
    std::uint64_t from_extent_x;
    std::uint64_t to_extent_y;
    std::uint64_t to_extent_x;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(write_box_e5b112ea_wide_parameters, size) == 0);
static_assert(offsetof(write_box_e5b112ea_wide_parameters, from_origin) == 12);
static_assert(offsetof(write_box_e5b112ea_wide_parameters, to_origin) == 24);
static_assert(offsetof(write_box_e5b112ea_wide_parameters, base) == 36);
static_assert(offsetof(write_box_e5b112ea_wide_parameters, from_extent_y) == 48);
static_assert(offsetof(write_box_e5b112ea_wide_parameters, from_extent_x) == 56);
static_assert(offsetof(write_box_e5b112ea_wide_parameters, to_extent_y) == 64);
static_assert(offsetof(write_box_e5b112ea_wide_parameters, to_extent_x) == 72);
static_assert(offsetof(write_box_e5b112ea_wide_parameters, from_data_address) == 80);
static_assert(offsetof(write_box_e5b112ea_wide_parameters, to_data_address) == 88);

// transfer.glift:20: runs kernel write_box<Box<3, float>, Array<3, float, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_e5b112ea_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_e5b112ea_wide_parameters*>(call.parameters);
    const uint3 from_origin = parameters.from_origin;
    const uint3 to_origin = parameters.to_origin;
    const std::uint64_t from_extent_y = parameters.from_extent_y;
    const std::uint64_t from_extent_x = parameters.from_extent_x;
    const std::uint64_t to_extent_y = parameters.to_extent_y;
    const std::uint64_t to_extent_x = parameters.to_extent_x;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint3 address{x, row.y, row.z};
            // transfer.glift:21
            const uint3 from_address = from_origin + address;
            // transfer.glift:20
            const std::uint64_t from_at = (std::uint64_t(from_address.z) * from_extent_y
                + std::uint64_t(from_address.y)) * from_extent_x + std::uint64_t(from_address.x);
            // transfer.glift:21
            const uint3 to_address = to_origin + address;
            // transfer.glift:20
            const std::uint64_t to_at = (std::uint64_t(to_address.z) * to_extent_y
                + std::uint64_t(to_address.y)) * to_extent_x + std::uint64_t(to_address.x);
            // transfer.glift:21
            to_data[to_at] = from_data[from_at];
        }
    }
}

static void write_box_e5b112ea_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_e5b112ea_wide_rows(call, rows); });
}

const glift::Binding write_box_e5b112ea_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 80,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 88,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter write_box_e5b112ea_parameters[] = {
    {"from_extent", 0, sizeof(write_box_e5b112ea_direct_parameters::from_extent)},
    {"to_extent", 12, sizeof(write_box_e5b112ea_direct_parameters::to_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_e5b112ea_kernel;
const glift::Kernel write_box_e5b112ea_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 3,
    .group = {32, 4, 2},
    .loop_rounds = 0,
    .bindings = write_box_e5b112ea_bindings,
    .direct = {.host = &write_box_e5b112ea_direct, .parameter_bytes = 24, .push_constants = true},
    .general = {.host = &write_box_e5b112ea_general, .parameter_bytes = 60},
    .wide = {.host = &write_box_e5b112ea_wide, .parameter_bytes = 96, .base_offset = 36},
    .parameters = write_box_e5b112ea_parameters,
    .items = {1, 2, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Array<3, float, none, buffer>, float>

namespace {
struct fill_box_bdadf51c_direct_parameters {
    uint3 to_extent;
    float value;
};
static_assert(offsetof(fill_box_bdadf51c_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_bdadf51c_direct_parameters, value) == 12);

// transfer.glift:25: runs kernel fill_box<Array<3, float, none, buffer>, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_bdadf51c_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_bdadf51c_direct_parameters*>(call.parameters);
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

static void fill_box_bdadf51c_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_bdadf51c_direct_rows(call, rows); });
}

struct fill_box_bdadf51c_general_parameters {
    uint3 size;
    uint3 to_origin;
    uint3 to_extent;
    float value;
};
static_assert(offsetof(fill_box_bdadf51c_general_parameters, size) == 0);
static_assert(offsetof(fill_box_bdadf51c_general_parameters, to_origin) == 12);
static_assert(offsetof(fill_box_bdadf51c_general_parameters, to_extent) == 24);
static_assert(offsetof(fill_box_bdadf51c_general_parameters, value) == 36);

// transfer.glift:25: runs kernel fill_box<Array<3, float, none, buffer>, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_bdadf51c_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_bdadf51c_general_parameters*>(call.parameters);
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

static void fill_box_bdadf51c_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_bdadf51c_general_rows(call,
        rows); });
}

struct fill_box_bdadf51c_wide_parameters {
    uint3 size;
    uint3 to_origin;
    uint3 base;
    std::uint64_t to_extent_y;
    std::uint64_t to_extent_x;
    float value;
    std::uint64_t to_data_address;
};
static_assert(offsetof(fill_box_bdadf51c_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_bdadf51c_wide_parameters, to_origin) == 12);
static_assert(offsetof(fill_box_bdadf51c_wide_parameters, base) == 24);
static_assert(offsetof(fill_box_bdadf51c_wide_parameters, to_extent_y) == 40);
static_assert(offsetof(fill_box_bdadf51c_wide_parameters, to_extent_x) == 48);
static_assert(offsetof(fill_box_bdadf51c_wide_parameters, value) == 56);
static_assert(offsetof(fill_box_bdadf51c_wide_parameters, to_data_address) == 64);

// transfer.glift:25: runs kernel fill_box<Array<3, float, none, buffer>, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_bdadf51c_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_bdadf51c_wide_parameters*>(call.parameters);
    const uint3 to_origin = parameters.to_origin;
    const std::uint64_t to_extent_y = parameters.to_extent_y;
    const std::uint64_t to_extent_x = parameters.to_extent_x;
    const float value = parameters.value;
    float* to_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint3 address{x, row.y, row.z};
            // transfer.glift:26
            const uint3 to_address = to_origin + address;
            // transfer.glift:25
            const std::uint64_t to_at = (std::uint64_t(to_address.z) * to_extent_y
                + std::uint64_t(to_address.y)) * to_extent_x + std::uint64_t(to_address.x);
            // transfer.glift:26
            to_data[to_at] = value;
        }
    }
}

static void fill_box_bdadf51c_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_bdadf51c_wide_rows(call, rows); });
}

const glift::Binding fill_box_bdadf51c_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 64,
        .element_bytes = sizeof(float)},
};
constexpr glift::Parameter fill_box_bdadf51c_parameters[] = {
    {"to_extent", 0, sizeof(fill_box_bdadf51c_direct_parameters::to_extent)},
    {"value", 12, sizeof(fill_box_bdadf51c_direct_parameters::value)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_bdadf51c_kernel;
const glift::Kernel fill_box_bdadf51c_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 3,
    .group = {32, 4, 2},
    .loop_rounds = 0,
    .bindings = fill_box_bdadf51c_bindings,
    .direct = {.host = &fill_box_bdadf51c_direct, .parameter_bytes = 16, .push_constants = true},
    .general = {.host = &fill_box_bdadf51c_general, .parameter_bytes = 40},
    .wide = {.host = &fill_box_bdadf51c_wide, .parameter_bytes = 72, .base_offset = 24},
    .parameters = fill_box_bdadf51c_parameters,
    .items = {1, 2, 1},
};

}  // namespace std_transfer

