// Made by gliftc from steps.glift. Changes are lost when it is made again.
#include "steps.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace std_transfer {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Array<1, float, none, buffer>, Box<1, float>>

namespace {
struct read_box_679e2ba9_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(read_box_679e2ba9_direct_parameters, from_extent) == 0);

// transfer.glift:15: runs kernel read_box<Array<1, float, none, buffer>, Box<1, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_679e2ba9_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            const float* from_data_row = glift::host::row_pointer(from_data + address);
            float* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:16
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void read_box_679e2ba9_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_679e2ba9_direct_rows(call, rows); });
}

struct read_box_679e2ba9_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(read_box_679e2ba9_general_parameters, size) == 0);
static_assert(offsetof(read_box_679e2ba9_general_parameters, from_origin) == 4);
static_assert(offsetof(read_box_679e2ba9_general_parameters, to_origin) == 8);

// transfer.glift:15: runs kernel read_box<Array<1, float, none, buffer>, Box<1, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_679e2ba9_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_679e2ba9_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // transfer.glift:16
            const uint from_address = from_origin + address;
            const uint to_address = to_origin + address;
            const float* from_data_row = glift::host::row_pointer(from_data + from_address);
            float* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:16
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void read_box_679e2ba9_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_679e2ba9_general_rows(call,
        rows); });
}

struct read_box_679e2ba9_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_679e2ba9_wide_parameters, size) == 0);
static_assert(offsetof(read_box_679e2ba9_wide_parameters, from_origin) == 4);
static_assert(offsetof(read_box_679e2ba9_wide_parameters, to_origin) == 8);
static_assert(offsetof(read_box_679e2ba9_wide_parameters, from_data_address) == 16);
static_assert(offsetof(read_box_679e2ba9_wide_parameters, to_data_address) == 24);

// transfer.glift:15: runs kernel read_box<Array<1, float, none, buffer>, Box<1, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_679e2ba9_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_679e2ba9_wide_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:16
            const uint from_address = from_origin + address;
            // transfer.glift:15
            const std::uint64_t from_at = std::uint64_t(from_address);
            // transfer.glift:16
            const uint to_address = to_origin + address;
            // transfer.glift:15
            const std::uint64_t to_at = std::uint64_t(to_address);
            // transfer.glift:16
            to_data[to_at] = from_data[from_at];
        }
    }
}

static void read_box_679e2ba9_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_679e2ba9_wide_rows(call, rows); });
}

const glift::Binding read_box_679e2ba9_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter read_box_679e2ba9_parameters[] = {
    {"from_extent", 0, sizeof(read_box_679e2ba9_direct_parameters::from_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_679e2ba9_kernel;
const glift::Kernel read_box_679e2ba9_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = read_box_679e2ba9_bindings,
    .direct = {.host = &read_box_679e2ba9_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &read_box_679e2ba9_general, .parameter_bytes = 12},
    .wide = {.host = &read_box_679e2ba9_wide, .parameter_bytes = 32},
    .parameters = read_box_679e2ba9_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<1, float>, Array<1, float, none, buffer>>

namespace {
struct write_box_7a558d52_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(write_box_7a558d52_direct_parameters, from_extent) == 0);

// transfer.glift:20: runs kernel write_box<Box<1, float>, Array<1, float, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_7a558d52_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            const float* from_data_row = glift::host::row_pointer(from_data + address);
            float* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:21
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void write_box_7a558d52_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_7a558d52_direct_rows(call,
        rows); });
}

struct write_box_7a558d52_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(write_box_7a558d52_general_parameters, size) == 0);
static_assert(offsetof(write_box_7a558d52_general_parameters, from_origin) == 4);
static_assert(offsetof(write_box_7a558d52_general_parameters, to_origin) == 8);

// transfer.glift:20: runs kernel write_box<Box<1, float>, Array<1, float, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_7a558d52_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_7a558d52_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // transfer.glift:21
            const uint from_address = from_origin + address;
            const uint to_address = to_origin + address;
            const float* from_data_row = glift::host::row_pointer(from_data + from_address);
            float* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:21
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void write_box_7a558d52_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_7a558d52_general_rows(call,
        rows); });
}

struct write_box_7a558d52_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(write_box_7a558d52_wide_parameters, size) == 0);
static_assert(offsetof(write_box_7a558d52_wide_parameters, from_origin) == 4);
static_assert(offsetof(write_box_7a558d52_wide_parameters, to_origin) == 8);
static_assert(offsetof(write_box_7a558d52_wide_parameters, from_data_address) == 16);
static_assert(offsetof(write_box_7a558d52_wide_parameters, to_data_address) == 24);

// transfer.glift:20: runs kernel write_box<Box<1, float>, Array<1, float, none, buffer>> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_7a558d52_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_7a558d52_wide_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:21
            const uint from_address = from_origin + address;
            // transfer.glift:20
            const std::uint64_t from_at = std::uint64_t(from_address);
            // transfer.glift:21
            const uint to_address = to_origin + address;
            // transfer.glift:20
            const std::uint64_t to_at = std::uint64_t(to_address);
            // transfer.glift:21
            to_data[to_at] = from_data[from_at];
        }
    }
}

static void write_box_7a558d52_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_7a558d52_wide_rows(call, rows); });
}

const glift::Binding write_box_7a558d52_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter write_box_7a558d52_parameters[] = {
    {"from_extent", 0, sizeof(write_box_7a558d52_direct_parameters::from_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_7a558d52_kernel;
const glift::Kernel write_box_7a558d52_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = write_box_7a558d52_bindings,
    .direct = {.host = &write_box_7a558d52_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &write_box_7a558d52_general, .parameter_bytes = 12},
    .wide = {.host = &write_box_7a558d52_wide, .parameter_bytes = 32},
    .parameters = write_box_7a558d52_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Array<1, float, none, buffer>, float>

namespace {
struct fill_box_4fb0cc86_direct_parameters {
    uint to_extent;
    float value;
};
static_assert(offsetof(fill_box_4fb0cc86_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_4fb0cc86_direct_parameters, value) == 4);

// transfer.glift:25: runs kernel fill_box<Array<1, float, none, buffer>, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_4fb0cc86_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_4fb0cc86_direct_parameters*>(call.parameters);
    const float value = parameters.value;
    float* to_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            float* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:26
                to_data_row[i] = value;
            }
        }
    }
}

static void fill_box_4fb0cc86_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_4fb0cc86_direct_rows(call, rows); });
}

struct fill_box_4fb0cc86_general_parameters {
    uint size;
    uint to_origin;
    float value;
};
static_assert(offsetof(fill_box_4fb0cc86_general_parameters, size) == 0);
static_assert(offsetof(fill_box_4fb0cc86_general_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_4fb0cc86_general_parameters, value) == 8);

// transfer.glift:25: runs kernel fill_box<Array<1, float, none, buffer>, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_4fb0cc86_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_4fb0cc86_general_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    const float value = parameters.value;
    float* to_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // transfer.glift:26
            const uint to_address = to_origin + address;
            float* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:26
                to_data_row[i] = value;
            }
        }
    }
}

static void fill_box_4fb0cc86_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_4fb0cc86_general_rows(call,
        rows); });
}

struct fill_box_4fb0cc86_wide_parameters {
    uint size;
    uint to_origin;
    float value;
    std::uint64_t to_data_address;
};
static_assert(offsetof(fill_box_4fb0cc86_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_4fb0cc86_wide_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_4fb0cc86_wide_parameters, value) == 8);
static_assert(offsetof(fill_box_4fb0cc86_wide_parameters, to_data_address) == 16);

// transfer.glift:25: runs kernel fill_box<Array<1, float, none, buffer>, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_4fb0cc86_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_4fb0cc86_wide_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    const float value = parameters.value;
    float* to_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:26
            const uint to_address = to_origin + address;
            // transfer.glift:25
            const std::uint64_t to_at = std::uint64_t(to_address);
            // transfer.glift:26
            to_data[to_at] = value;
        }
    }
}

static void fill_box_4fb0cc86_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_4fb0cc86_wide_rows(call, rows); });
}

const glift::Binding fill_box_4fb0cc86_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 16,
        .element_bytes = sizeof(float)},
};
constexpr glift::Parameter fill_box_4fb0cc86_parameters[] = {
    {"to_extent", 0, sizeof(fill_box_4fb0cc86_direct_parameters::to_extent)},
    {"value", 4, sizeof(fill_box_4fb0cc86_direct_parameters::value)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_4fb0cc86_kernel;
const glift::Kernel fill_box_4fb0cc86_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = fill_box_4fb0cc86_bindings,
    .direct = {.host = &fill_box_4fb0cc86_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &fill_box_4fb0cc86_general, .parameter_bytes = 12},
    .wide = {.host = &fill_box_4fb0cc86_wide, .parameter_bytes = 24},
    .parameters = fill_box_4fb0cc86_parameters,
    .items = {2, 1, 1},
};

}  // namespace std_transfer

