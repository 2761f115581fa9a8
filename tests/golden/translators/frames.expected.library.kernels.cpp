// Made by gliftc from frames.glift. Changes are lost when it is made again.
#include "frames.glift.types.hpp"

#include <glift/host/atomics.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace std_transfer {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Pool, Box<1, float>>

namespace {
struct read_box_1f848e0d_direct_parameters {
    uint from_frames_n;
    uint from_data_extent;
};
static_assert(offsetof(read_box_1f848e0d_direct_parameters, from_frames_n) == 0);
static_assert(offsetof(read_box_1f848e0d_direct_parameters, from_data_extent) == 4);

// transfer.glift:15: runs kernel read_box<Pool, Box<1, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_1f848e0d_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_1f848e0d_direct_parameters*>(call.parameters);
    const uint from_frames_n = parameters.from_frames_n;
    const uint from_data_extent = parameters.from_data_extent;
    const uint* from_frames_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_data = glift::host::elements<const float>(call.memories[1]);
    float* to_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            float* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint address = row.begin + static_cast<uint>(i);
                // transfer.glift:15
                const uint from_frames_address = address / 4u;
                const bool from_frames_value_inside = from_frames_address < from_frames_n;
                const uint from_frames_value = from_frames_data[from_frames_value_inside ? from_frames_address : 0u];
                const uint from_frame = from_frames_value_inside ? from_frames_value : 0u;
                const uint from_place = (from_frame - 1u) * 4u + address % 4u;
                const bool from_found = !(from_frame == 0u) && from_place < from_data_extent;
                // transfer.glift:16
                const float from_value = from_data[from_found ? from_place : 0u];
                to_data_row[i] = from_found ? from_value : -1.0f;
            }
        }
    }
}

static void read_box_1f848e0d_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_1f848e0d_direct_rows(call, rows); });
}

struct read_box_1f848e0d_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    uint from_frames_n;
    uint from_data_extent;
};
static_assert(offsetof(read_box_1f848e0d_general_parameters, size) == 0);
static_assert(offsetof(read_box_1f848e0d_general_parameters, from_origin) == 4);
static_assert(offsetof(read_box_1f848e0d_general_parameters, to_origin) == 8);
static_assert(offsetof(read_box_1f848e0d_general_parameters, from_frames_n) == 12);
static_assert(offsetof(read_box_1f848e0d_general_parameters, from_data_extent) == 16);

// transfer.glift:15: runs kernel read_box<Pool, Box<1, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_1f848e0d_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_1f848e0d_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint from_frames_n = parameters.from_frames_n;
    const uint from_data_extent = parameters.from_data_extent;
    const uint* from_frames_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_data = glift::host::elements<const float>(call.memories[1]);
    float* to_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // transfer.glift:16
            const uint to_address = to_origin + address;
            float* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint address = row.begin + static_cast<uint>(i);
                // transfer.glift:16
                const uint from_address = from_origin + address;
                // transfer.glift:15
                const uint from_frames_address = from_address / 4u;
                const bool from_frames_value_inside = from_frames_address < from_frames_n;
                const uint from_frames_value = from_frames_data[from_frames_value_inside ? from_frames_address : 0u];
                const uint from_frame = from_frames_value_inside ? from_frames_value : 0u;
                const uint from_place = (from_frame - 1u) * 4u + from_address % 4u;
                const bool from_found = !(from_frame == 0u) && from_place < from_data_extent;
                // transfer.glift:16
                const float from_value = from_data[from_found ? from_place : 0u];
                to_data_row[i] = from_found ? from_value : -1.0f;
            }
        }
    }
}

static void read_box_1f848e0d_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_1f848e0d_general_rows(call,
        rows); });
}

struct read_box_1f848e0d_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    uint from_frames_n;
    std::uint64_t from_data_extent;
    std::uint64_t from_frames_data_address;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_1f848e0d_wide_parameters, size) == 0);
static_assert(offsetof(read_box_1f848e0d_wide_parameters, from_origin) == 4);
static_assert(offsetof(read_box_1f848e0d_wide_parameters, to_origin) == 8);
static_assert(offsetof(read_box_1f848e0d_wide_parameters, from_frames_n) == 12);
static_assert(offsetof(read_box_1f848e0d_wide_parameters, from_data_extent) == 16);
static_assert(offsetof(read_box_1f848e0d_wide_parameters, from_frames_data_address) == 24);
static_assert(offsetof(read_box_1f848e0d_wide_parameters, from_data_address) == 32);
static_assert(offsetof(read_box_1f848e0d_wide_parameters, to_data_address) == 40);

// transfer.glift:15: runs kernel read_box<Pool, Box<1, float>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_1f848e0d_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_1f848e0d_wide_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint from_frames_n = parameters.from_frames_n;
    const std::uint64_t from_data_extent = parameters.from_data_extent;
    const uint* from_frames_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_data = glift::host::elements<const float>(call.memories[1]);
    float* to_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:16
            const uint from_address = from_origin + address;
            // transfer.glift:15
            const uint from_frames_address = from_address / 4u;
            const bool from_frames_value_inside = from_frames_address < from_frames_n;
            const uint from_frames_value = from_frames_data[std::uint64_t(from_frames_value_inside ? from_frames_address
                : 0u)];
            const uint from_frame = from_frames_value_inside ? from_frames_value : 0u;
            const std::uint64_t from_place = (std::uint64_t(from_frame) - std::uint64_t{1u}) * std::uint64_t{4u}
                + std::uint64_t(from_address % 4u);
            const bool from_found = !(from_frame == 0u) && from_place < from_data_extent;
            // transfer.glift:16
            const uint to_address = to_origin + address;
            // transfer.glift:15
            const std::uint64_t to_at = std::uint64_t(to_address);
            // transfer.glift:16
            const float from_value = from_data[from_found ? from_place : std::uint64_t{0u}];
            to_data[to_at] = from_found ? from_value : -1.0f;
        }
    }
}

static void read_box_1f848e0d_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_1f848e0d_wide_rows(call, rows); });
}

const glift::Binding read_box_1f848e0d_bindings[] = {
    {.name = "from.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24,
        .element_bytes = sizeof(uint)},
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 32,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 40,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter read_box_1f848e0d_parameters[] = {
    {"from_frames_n", 0, sizeof(read_box_1f848e0d_direct_parameters::from_frames_n)},
    {"from_data_extent", 4, sizeof(read_box_1f848e0d_direct_parameters::from_data_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_1f848e0d_kernel;
const glift::Kernel read_box_1f848e0d_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = read_box_1f848e0d_bindings,
    .direct = {.host = &read_box_1f848e0d_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &read_box_1f848e0d_general, .parameter_bytes = 20},
    .wide = {.host = &read_box_1f848e0d_wide, .parameter_bytes = 48},
    .parameters = read_box_1f848e0d_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<1, float>, Pool>

namespace {
struct write_box_31432b0a_direct_parameters {
    uint from_extent;
    uint to_frames_n;
    uint to_data_extent;
};
static_assert(offsetof(write_box_31432b0a_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_31432b0a_direct_parameters, to_frames_n) == 4);
static_assert(offsetof(write_box_31432b0a_direct_parameters, to_data_extent) == 8);

// transfer.glift:20: runs kernel write_box<Box<1, float>, Pool> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_31432b0a_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_31432b0a_direct_parameters*>(call.parameters);
    const uint to_frames_n = parameters.to_frames_n;
    const uint to_data_extent = parameters.to_data_extent;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    const uint* to_frames_data = glift::host::elements<const uint>(call.memories[1]);
    float* to_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:20
            const uint to_frames_address = address / 4u;
            const bool to_frames_value_inside = to_frames_address < to_frames_n;
            const uint to_frames_value = to_frames_data[to_frames_value_inside ? to_frames_address : 0u];
            const uint to_frame = to_frames_value_inside ? to_frames_value : 0u;
            const uint to_place = (to_frame - 1u) * 4u + address % 4u;
            const bool to_found = !(to_frame == 0u) && to_place < to_data_extent;
            // transfer.glift:21
            if (to_found) {
                to_data[to_place] = from_data[address];
            }
        }
    }
}

static void write_box_31432b0a_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_31432b0a_direct_rows(call,
        rows); });
}

struct write_box_31432b0a_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    uint to_frames_n;
    uint to_data_extent;
};
static_assert(offsetof(write_box_31432b0a_general_parameters, size) == 0);
static_assert(offsetof(write_box_31432b0a_general_parameters, from_origin) == 4);
static_assert(offsetof(write_box_31432b0a_general_parameters, to_origin) == 8);
static_assert(offsetof(write_box_31432b0a_general_parameters, to_frames_n) == 12);
static_assert(offsetof(write_box_31432b0a_general_parameters, to_data_extent) == 16);

// transfer.glift:20: runs kernel write_box<Box<1, float>, Pool> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_31432b0a_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_31432b0a_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint to_frames_n = parameters.to_frames_n;
    const uint to_data_extent = parameters.to_data_extent;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    const uint* to_frames_data = glift::host::elements<const uint>(call.memories[1]);
    float* to_data = glift::host::elements<float>(call.memories[2]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:21
            const uint from_address = from_origin + address;
            const uint to_address = to_origin + address;
            // transfer.glift:20
            const uint to_frames_address = to_address / 4u;
            const bool to_frames_value_inside = to_frames_address < to_frames_n;
            const uint to_frames_value = to_frames_data[to_frames_value_inside ? to_frames_address : 0u];
            const uint to_frame = to_frames_value_inside ? to_frames_value : 0u;
            const uint to_place = (to_frame - 1u) * 4u + to_address % 4u;
            const bool to_found = !(to_frame == 0u) && to_place < to_data_extent;
            // transfer.glift:21
            if (to_found) {
                to_data[to_place] = from_data[from_address];
            }
        }
    }
}

static void write_box_31432b0a_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_31432b0a_general_rows(call,
        rows); });
}

struct write_box_31432b0a_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    uint to_frames_n;
    std::uint64_t to_data_extent;
    std::uint64_t from_data_address;
    std::uint64_t to_frames_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(write_box_31432b0a_wide_parameters, size) == 0);
static_assert(offsetof(write_box_31432b0a_wide_parameters, from_origin) == 4);
static_assert(offsetof(write_box_31432b0a_wide_parameters, to_origin) == 8);
static_assert(offsetof(write_box_31432b0a_wide_parameters, to_frames_n) == 12);
static_assert(offsetof(write_box_31432b0a_wide_parameters, to_data_extent) == 16);
static_assert(offsetof(write_box_31432b0a_wide_parameters, from_data_address) == 24);
static_assert(offsetof(write_box_31432b0a_wide_parameters, to_frames_data_address) == 32);
static_assert(offsetof(write_box_31432b0a_wide_parameters, to_data_address) == 40);

// transfer.glift:20: runs kernel write_box<Box<1, float>, Pool> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_31432b0a_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_31432b0a_wide_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint to_frames_n = parameters.to_frames_n;
    const std::uint64_t to_data_extent = parameters.to_data_extent;
    const float* from_data = glift::host::elements<const float>(call.memories[0]);
    const uint* to_frames_data = glift::host::elements<const uint>(call.memories[1]);
    float* to_data = glift::host::elements<float>(call.memories[2]);
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
            const uint to_frames_address = to_address / 4u;
            const bool to_frames_value_inside = to_frames_address < to_frames_n;
            const uint to_frames_value = to_frames_data[std::uint64_t(to_frames_value_inside ? to_frames_address : 0u)];
            const uint to_frame = to_frames_value_inside ? to_frames_value : 0u;
            const std::uint64_t to_place = (std::uint64_t(to_frame) - std::uint64_t{1u}) * std::uint64_t{4u}
                + std::uint64_t(to_address % 4u);
            const bool to_found = !(to_frame == 0u) && to_place < to_data_extent;
            // transfer.glift:21
            if (to_found) {
                to_data[to_place] = from_data[from_at];
            }
        }
    }
}

static void write_box_31432b0a_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_31432b0a_wide_rows(call, rows); });
}

const glift::Binding write_box_31432b0a_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
    {.name = "to.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 32,
        .element_bytes = sizeof(uint), .parameter = 1},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 40,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter write_box_31432b0a_parameters[] = {
    {"from_extent", 0, sizeof(write_box_31432b0a_direct_parameters::from_extent)},
    {"to_frames_n", 4, sizeof(write_box_31432b0a_direct_parameters::to_frames_n)},
    {"to_data_extent", 8, sizeof(write_box_31432b0a_direct_parameters::to_data_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_31432b0a_kernel;
const glift::Kernel write_box_31432b0a_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = write_box_31432b0a_bindings,
    .direct = {.host = &write_box_31432b0a_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &write_box_31432b0a_general, .parameter_bytes = 20},
    .wide = {.host = &write_box_31432b0a_wide, .parameter_bytes = 48},
    .parameters = write_box_31432b0a_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Pool, float>

namespace {
struct fill_box_frames_Pool_float_direct_parameters {
    uint to_frames_n;
    uint to_data_extent;
    float value;
};
static_assert(offsetof(fill_box_frames_Pool_float_direct_parameters, to_frames_n) == 0);
static_assert(offsetof(fill_box_frames_Pool_float_direct_parameters, to_data_extent) == 4);
static_assert(offsetof(fill_box_frames_Pool_float_direct_parameters, value) == 8);

// transfer.glift:25: runs kernel fill_box<Pool, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_frames_Pool_float_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_frames_Pool_float_direct_parameters*>(call.parameters);
    const uint to_frames_n = parameters.to_frames_n;
    const uint to_data_extent = parameters.to_data_extent;
    const float value = parameters.value;
    const uint* to_frames_data = glift::host::elements<const uint>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:25
            const uint to_frames_address = address / 4u;
            const bool to_frames_value_inside = to_frames_address < to_frames_n;
            const uint to_frames_value = to_frames_data[to_frames_value_inside ? to_frames_address : 0u];
            const uint to_frame = to_frames_value_inside ? to_frames_value : 0u;
            const uint to_place = (to_frame - 1u) * 4u + address % 4u;
            const bool to_found = !(to_frame == 0u) && to_place < to_data_extent;
            // transfer.glift:26
            if (to_found) {
                to_data[to_place] = value;
            }
        }
    }
}

static void fill_box_frames_Pool_float_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_frames_Pool_float_direct_rows(call,
        rows); });
}

struct fill_box_frames_Pool_float_general_parameters {
    uint size;
    uint to_origin;
    uint to_frames_n;
    uint to_data_extent;
    float value;
};
static_assert(offsetof(fill_box_frames_Pool_float_general_parameters, size) == 0);
static_assert(offsetof(fill_box_frames_Pool_float_general_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_frames_Pool_float_general_parameters, to_frames_n) == 8);
static_assert(offsetof(fill_box_frames_Pool_float_general_parameters, to_data_extent) == 12);
static_assert(offsetof(fill_box_frames_Pool_float_general_parameters, value) == 16);

// transfer.glift:25: runs kernel fill_box<Pool, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_frames_Pool_float_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_frames_Pool_float_general_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    const uint to_frames_n = parameters.to_frames_n;
    const uint to_data_extent = parameters.to_data_extent;
    const float value = parameters.value;
    const uint* to_frames_data = glift::host::elements<const uint>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:26
            const uint to_address = to_origin + address;
            // transfer.glift:25
            const uint to_frames_address = to_address / 4u;
            const bool to_frames_value_inside = to_frames_address < to_frames_n;
            const uint to_frames_value = to_frames_data[to_frames_value_inside ? to_frames_address : 0u];
            const uint to_frame = to_frames_value_inside ? to_frames_value : 0u;
            const uint to_place = (to_frame - 1u) * 4u + to_address % 4u;
            const bool to_found = !(to_frame == 0u) && to_place < to_data_extent;
            // transfer.glift:26
            if (to_found) {
                to_data[to_place] = value;
            }
        }
    }
}

static void fill_box_frames_Pool_float_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_frames_Pool_float_general_rows(call,
        rows); });
}

struct fill_box_frames_Pool_float_wide_parameters {
    uint size;
    uint to_origin;
    uint to_frames_n;
    std::uint64_t to_data_extent;
    float value;
    std::uint64_t to_frames_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(fill_box_frames_Pool_float_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_frames_Pool_float_wide_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_frames_Pool_float_wide_parameters, to_frames_n) == 8);
static_assert(offsetof(fill_box_frames_Pool_float_wide_parameters, to_data_extent) == 16);
static_assert(offsetof(fill_box_frames_Pool_float_wide_parameters, value) == 24);
static_assert(offsetof(fill_box_frames_Pool_float_wide_parameters, to_frames_data_address) == 32);
static_assert(offsetof(fill_box_frames_Pool_float_wide_parameters, to_data_address) == 40);

// transfer.glift:25: runs kernel fill_box<Pool, float> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_frames_Pool_float_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_frames_Pool_float_wide_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    const uint to_frames_n = parameters.to_frames_n;
    const std::uint64_t to_data_extent = parameters.to_data_extent;
    const float value = parameters.value;
    const uint* to_frames_data = glift::host::elements<const uint>(call.memories[0]);
    float* to_data = glift::host::elements<float>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:26
            const uint to_address = to_origin + address;
            // transfer.glift:25
            const uint to_frames_address = to_address / 4u;
            const bool to_frames_value_inside = to_frames_address < to_frames_n;
            const uint to_frames_value = to_frames_data[std::uint64_t(to_frames_value_inside ? to_frames_address : 0u)];
            const uint to_frame = to_frames_value_inside ? to_frames_value : 0u;
            const std::uint64_t to_place = (std::uint64_t(to_frame) - std::uint64_t{1u}) * std::uint64_t{4u}
                + std::uint64_t(to_address % 4u);
            const bool to_found = !(to_frame == 0u) && to_place < to_data_extent;
            // transfer.glift:26
            if (to_found) {
                to_data[to_place] = value;
            }
        }
    }
}

static void fill_box_frames_Pool_float_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_frames_Pool_float_wide_rows(call,
        rows); });
}

const glift::Binding fill_box_frames_Pool_float_bindings[] = {
    {.name = "to.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 32,
        .element_bytes = sizeof(uint)},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 40,
        .element_bytes = sizeof(float), .reach = glift::Reach::element},
};
constexpr glift::Parameter fill_box_frames_Pool_float_parameters[] = {
    {"to_frames_n", 0, sizeof(fill_box_frames_Pool_float_direct_parameters::to_frames_n)},
    {"to_data_extent", 4, sizeof(fill_box_frames_Pool_float_direct_parameters::to_data_extent)},
    {"value", 8, sizeof(fill_box_frames_Pool_float_direct_parameters::value)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_frames_Pool_float_kernel;
const glift::Kernel fill_box_frames_Pool_float_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = fill_box_frames_Pool_float_bindings,
    .direct = {.host = &fill_box_frames_Pool_float_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &fill_box_frames_Pool_float_general, .parameter_bytes = 20},
    .wide = {.host = &fill_box_frames_Pool_float_wide, .parameter_bytes = 48},
    .parameters = fill_box_frames_Pool_float_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:32: list_there<Pool, Pool, Box<1, uint>, Box<1, uint>, Box<1, float>, Box<1, uint>>

namespace {
struct list_there_d62ad97a_direct_parameters {
    uint a_frames_n;
    uint a_data_extent;
    glift::Bool counter_extent_value_0;
    uint addresses_extent;
    uint values_extent;
    uint translated_frames_n;
    uint translated_data_extent;
    uint places_extent;
};
static_assert(offsetof(list_there_d62ad97a_direct_parameters, a_frames_n) == 0);
static_assert(offsetof(list_there_d62ad97a_direct_parameters, a_data_extent) == 4);
static_assert(offsetof(list_there_d62ad97a_direct_parameters, counter_extent_value_0) == 8);
static_assert(offsetof(list_there_d62ad97a_direct_parameters, addresses_extent) == 12);
static_assert(offsetof(list_there_d62ad97a_direct_parameters, values_extent) == 16);
static_assert(offsetof(list_there_d62ad97a_direct_parameters, translated_frames_n) == 20);
static_assert(offsetof(list_there_d62ad97a_direct_parameters, translated_data_extent) == 24);
static_assert(offsetof(list_there_d62ad97a_direct_parameters, places_extent) == 28);

// transfer.glift:32: runs kernel list_there<Pool, Pool, Box<1, uint>, Box<1, uint>, Box<1, float>, Box<1, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void list_there_d62ad97a_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const list_there_d62ad97a_direct_parameters*>(call.parameters);
    const uint a_frames_n = parameters.a_frames_n;
    const uint a_data_extent = parameters.a_data_extent;
    const bool counter_extent_value_0 = parameters.counter_extent_value_0;
    const uint addresses_extent = parameters.addresses_extent;
    const uint values_extent = parameters.values_extent;
    const uint translated_frames_n = parameters.translated_frames_n;
    const uint translated_data_extent = parameters.translated_data_extent;
    const uint places_extent = parameters.places_extent;
    const uint* from_frames_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_data = glift::host::elements<const float>(call.memories[1]);
    uint* counter_data = glift::host::elements<uint>(call.memories[2]);
    uint* addresses_data = glift::host::elements<uint>(call.memories[3]);
    float* values_data = glift::host::elements<float>(call.memories[4]);
    const uint* translated_frames_data = glift::host::elements<const uint>(call.memories[5]);
    uint* places_data = glift::host::elements<uint>(call.memories[6]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:36
            const uint from_frames_address = address / 4u;
            const bool from_frames_value_inside = from_frames_address < a_frames_n;
            const uint from_frames_value = from_frames_data[from_frames_value_inside ? from_frames_address : 0u];
            const uint from_frame = from_frames_value_inside ? from_frames_value : 0u;
            const uint value = address % 4u;
            const uint from_place = (from_frame - 1u) * 4u + value;
            float result{};
            bool found{};
            if (!(from_frame == 0u) && from_place < a_data_extent) {
                const float from_value = from_data[from_place];
                result = from_value;
                found = true;
            } else {
                result = 0.0f;
                found = false;
            }
            const float found_2 = result;
            const bool found_found = found;
            if (found_found) {
                // transfer.glift:37
                uint counter_before = 0u;
                if (counter_extent_value_0) {
                    counter_before = glift::host::memory::atomicAdd(counter_data[0u], 1u);
                }
                const uint entry = counter_before;
                // transfer.glift:38
                if (entry < addresses_extent) {
                    addresses_data[entry] = address;
                }
                // transfer.glift:39
                if (entry < values_extent) {
                    values_data[entry] = found_2;
                }
                // transfer.glift:40
                const bool translated_frames_value_inside = from_frames_address < translated_frames_n;
                const uint translated_frames_value = translated_frames_data[translated_frames_value_inside
                    ? from_frames_address : 0u];
                const uint translated_frame = translated_frames_value_inside ? translated_frames_value : 0u;
                const uint translated_place = (translated_frame - 1u) * 4u + value;
                const bool found_found_2 = !(translated_frame == 0u) && translated_place < translated_data_extent;
                if (found_found_2) {
                    // transfer.glift:41
                    if (entry < places_extent) {
                        places_data[entry] = translated_place;
                    }
                }
            }
        }
    }
}

static void list_there_d62ad97a_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { list_there_d62ad97a_direct_rows(call,
        rows); });
}

struct list_there_d62ad97a_general_parameters {
    uint size;
    uint a_origin;
    uint from_origin;
    uint counter_origin;
    uint counter_size;
    uint addresses_origin;
    uint addresses_size;
    uint values_origin;
    uint values_size;
    uint translated_origin;
    uint places_origin;
    uint places_size;
    uint from_frames_n;
    uint from_data_extent;
    uint translated_frames_n;
    uint translated_data_extent;
};
static_assert(offsetof(list_there_d62ad97a_general_parameters, size) == 0);
static_assert(offsetof(list_there_d62ad97a_general_parameters, a_origin) == 4);
static_assert(offsetof(list_there_d62ad97a_general_parameters, from_origin) == 8);
static_assert(offsetof(list_there_d62ad97a_general_parameters, counter_origin) == 12);
static_assert(offsetof(list_there_d62ad97a_general_parameters, counter_size) == 16);
static_assert(offsetof(list_there_d62ad97a_general_parameters, addresses_origin) == 20);
static_assert(offsetof(list_there_d62ad97a_general_parameters, addresses_size) == 24);
static_assert(offsetof(list_there_d62ad97a_general_parameters, values_origin) == 28);
static_assert(offsetof(list_there_d62ad97a_general_parameters, values_size) == 32);
static_assert(offsetof(list_there_d62ad97a_general_parameters, translated_origin) == 36);
static_assert(offsetof(list_there_d62ad97a_general_parameters, places_origin) == 40);
static_assert(offsetof(list_there_d62ad97a_general_parameters, places_size) == 44);
static_assert(offsetof(list_there_d62ad97a_general_parameters, from_frames_n) == 48);
static_assert(offsetof(list_there_d62ad97a_general_parameters, from_data_extent) == 52);
static_assert(offsetof(list_there_d62ad97a_general_parameters, translated_frames_n) == 56);
static_assert(offsetof(list_there_d62ad97a_general_parameters, translated_data_extent) == 60);

// transfer.glift:32: runs kernel list_there<Pool, Pool, Box<1, uint>, Box<1, uint>, Box<1, float>, Box<1, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void list_there_d62ad97a_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const list_there_d62ad97a_general_parameters*>(call.parameters);
    const uint a_origin = parameters.a_origin;
    const uint from_origin = parameters.from_origin;
    const uint counter_origin = parameters.counter_origin;
    const uint counter_size = parameters.counter_size;
    const uint addresses_origin = parameters.addresses_origin;
    const uint addresses_size = parameters.addresses_size;
    const uint values_origin = parameters.values_origin;
    const uint values_size = parameters.values_size;
    const uint translated_origin = parameters.translated_origin;
    const uint places_origin = parameters.places_origin;
    const uint places_size = parameters.places_size;
    const uint from_frames_n = parameters.from_frames_n;
    const uint from_data_extent = parameters.from_data_extent;
    const uint translated_frames_n = parameters.translated_frames_n;
    const uint translated_data_extent = parameters.translated_data_extent;
    const uint* from_frames_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_data = glift::host::elements<const float>(call.memories[1]);
    uint* counter_data = glift::host::elements<uint>(call.memories[2]);
    uint* addresses_data = glift::host::elements<uint>(call.memories[3]);
    float* values_data = glift::host::elements<float>(call.memories[4]);
    const uint* translated_frames_data = glift::host::elements<const uint>(call.memories[5]);
    uint* places_data = glift::host::elements<uint>(call.memories[6]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:36
            const uint a_address = a_origin + address;
            const uint from_virtual = from_origin + a_address;
            const uint from_frames_address = from_virtual / 4u;
            const bool from_frames_value_inside = from_frames_address < from_frames_n;
            const uint from_frames_value = from_frames_data[from_frames_value_inside ? from_frames_address : 0u];
            const uint from_frame = from_frames_value_inside ? from_frames_value : 0u;
            const uint from_place = (from_frame - 1u) * 4u + from_virtual % 4u;
            float result{};
            bool found{};
            if (!(from_frame == 0u) && from_place < from_data_extent) {
                const float from_value = from_data[from_place];
                result = from_value;
                found = true;
            } else {
                result = 0.0f;
                found = false;
            }
            const float found_2 = result;
            const bool found_found = found;
            if (found_found) {
                // transfer.glift:37
                uint counter_before = 0u;
                if (0u < counter_size) {
                    counter_before = glift::host::memory::atomicAdd(counter_data[counter_origin], 1u);
                }
                const uint entry = counter_before;
                // transfer.glift:38
                const uint addresses_virtual = addresses_origin + entry;
                if (entry < addresses_size) {
                    addresses_data[addresses_virtual] = a_address;
                }
                // transfer.glift:39
                const uint values_virtual = values_origin + entry;
                if (entry < values_size) {
                    values_data[values_virtual] = found_2;
                }
                // transfer.glift:40
                const uint value = translated_origin + a_address;
                const uint translated_frames_address = value / 4u;
                const bool translated_frames_value_inside = translated_frames_address < translated_frames_n;
                const uint translated_frames_value = translated_frames_data[translated_frames_value_inside
                    ? translated_frames_address : 0u];
                const uint translated_frame = translated_frames_value_inside ? translated_frames_value : 0u;
                const uint translated_place = (translated_frame - 1u) * 4u + value % 4u;
                const bool found_found_2 = !(translated_frame == 0u) && translated_place < translated_data_extent;
                if (found_found_2) {
                    // transfer.glift:41
                    const uint places_virtual = places_origin + entry;
                    if (entry < places_size) {
                        places_data[places_virtual] = translated_place;
                    }
                }
            }
        }
    }
}

static void list_there_d62ad97a_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { list_there_d62ad97a_general_rows(call,
        rows); });
}

struct list_there_d62ad97a_wide_parameters {
    uint size;
    uint a_origin;
    uint from_origin;
    uint counter_origin;
    uint counter_size;
    uint addresses_origin;
    uint addresses_size;
    uint values_origin;
    uint values_size;
    uint translated_origin;
    uint places_origin;
    uint places_size;
    uint from_frames_n;
    std::uint64_t from_data_extent;
    uint translated_frames_n;
    std::uint64_t translated_data_extent;
    std::uint64_t from_frames_data_address;
    std::uint64_t from_data_address;
    std::uint64_t counter_data_address;
    std::uint64_t addresses_data_address;
    std::uint64_t values_data_address;
    std::uint64_t translated_frames_data_address;
    std::uint64_t places_data_address;
};
static_assert(offsetof(list_there_d62ad97a_wide_parameters, size) == 0);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, a_origin) == 4);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, from_origin) == 8);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, counter_origin) == 12);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, counter_size) == 16);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, addresses_origin) == 20);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, addresses_size) == 24);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, values_origin) == 28);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, values_size) == 32);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, translated_origin) == 36);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, places_origin) == 40);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, places_size) == 44);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, from_frames_n) == 48);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, from_data_extent) == 56);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, translated_frames_n) == 64);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, translated_data_extent) == 72);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, from_frames_data_address) == 80);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, from_data_address) == 88);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, counter_data_address) == 96);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, addresses_data_address) == 104);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, values_data_address) == 112);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, translated_frames_data_address) == 120);
static_assert(offsetof(list_there_d62ad97a_wide_parameters, places_data_address) == 128);

// transfer.glift:32: runs kernel list_there<Pool, Pool, Box<1, uint>, Box<1, uint>, Box<1, float>, Box<1, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void list_there_d62ad97a_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const list_there_d62ad97a_wide_parameters*>(call.parameters);
    const uint a_origin = parameters.a_origin;
    const uint from_origin = parameters.from_origin;
    const uint counter_origin = parameters.counter_origin;
    const uint counter_size = parameters.counter_size;
    const uint addresses_origin = parameters.addresses_origin;
    const uint addresses_size = parameters.addresses_size;
    const uint values_origin = parameters.values_origin;
    const uint values_size = parameters.values_size;
    const uint translated_origin = parameters.translated_origin;
    const uint places_origin = parameters.places_origin;
    const uint places_size = parameters.places_size;
    const uint from_frames_n = parameters.from_frames_n;
    const std::uint64_t from_data_extent = parameters.from_data_extent;
    const uint translated_frames_n = parameters.translated_frames_n;
    const std::uint64_t translated_data_extent = parameters.translated_data_extent;
    const uint* from_frames_data = glift::host::elements<const uint>(call.memories[0]);
    const float* from_data = glift::host::elements<const float>(call.memories[1]);
    uint* counter_data = glift::host::elements<uint>(call.memories[2]);
    uint* addresses_data = glift::host::elements<uint>(call.memories[3]);
    float* values_data = glift::host::elements<float>(call.memories[4]);
    const uint* translated_frames_data = glift::host::elements<const uint>(call.memories[5]);
    uint* places_data = glift::host::elements<uint>(call.memories[6]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:36
            const uint a_address = a_origin + address;
            const uint from_virtual = from_origin + a_address;
            const uint from_frames_address = from_virtual / 4u;
            const bool from_frames_value_inside = from_frames_address < from_frames_n;
            const uint from_frames_value = from_frames_data[std::uint64_t(from_frames_value_inside ? from_frames_address
                : 0u)];
            const uint from_frame = from_frames_value_inside ? from_frames_value : 0u;
            const std::uint64_t from_place = (std::uint64_t(from_frame) - std::uint64_t{1u}) * std::uint64_t{4u}
                + std::uint64_t(from_virtual % 4u);
            float result{};
            bool found{};
            if (!(from_frame == 0u) && from_place < from_data_extent) {
                const float from_value = from_data[from_place];
                result = from_value;
                found = true;
            } else {
                result = 0.0f;
                found = false;
            }
            const float found_2 = result;
            const bool found_found = found;
            if (found_found) {
                // transfer.glift:37
                uint counter_before = 0u;
                if (0u < counter_size) {
                    counter_before = glift::host::memory::atomicAdd(counter_data[std::uint64_t(counter_origin)], 1u);
                }
                const uint entry = counter_before;
                // transfer.glift:38
                const uint addresses_virtual = addresses_origin + entry;
                if (entry < addresses_size) {
                    addresses_data[std::uint64_t(addresses_virtual)] = a_address;
                }
                // transfer.glift:39
                const uint values_virtual = values_origin + entry;
                if (entry < values_size) {
                    values_data[std::uint64_t(values_virtual)] = found_2;
                }
                // transfer.glift:40
                const uint value = translated_origin + a_address;
                const uint translated_frames_address = value / 4u;
                const bool translated_frames_value_inside = translated_frames_address < translated_frames_n;
                const uint translated_frames_value = translated_frames_data[std::uint64_t(translated_frames_value_inside
                    ? translated_frames_address : 0u)];
                const uint translated_frame = translated_frames_value_inside ? translated_frames_value : 0u;
                const std::uint64_t translated_place = (std::uint64_t(translated_frame) - std::uint64_t{1u}) * std::uint64_t{4u} + std::uint64_t(value % 4u);
                const uint found_3 = uint(translated_place);
                const bool found_found_2 = !(translated_frame == 0u) && translated_place < translated_data_extent;
                if (found_found_2) {
                    // transfer.glift:41
                    const uint places_virtual = places_origin + entry;
                    if (entry < places_size) {
                        places_data[std::uint64_t(places_virtual)] = found_3;
                    }
                }
            }
        }
    }
}

static void list_there_d62ad97a_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { list_there_d62ad97a_wide_rows(call, rows); });
}

const glift::Binding list_there_d62ad97a_bindings[] = {
    {.name = "from.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 80,
        .element_bytes = sizeof(uint), .parameter = 1},
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 88,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::range},
    {.name = "counter.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read_write,
        .address_offset = 96, .element_bytes = sizeof(uint), .parameter = 3, .reach = glift::Reach::range,
        .combine = glift::Combine::coherent},
    {.name = "addresses.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 104,
        .element_bytes = sizeof(uint), .parameter = 4, .reach = glift::Reach::range},
    {.name = "values.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 112,
        .element_bytes = sizeof(float), .parameter = 6, .reach = glift::Reach::range},
    {.name = "translated.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read,
        .address_offset = 120, .element_bytes = sizeof(uint), .parameter = 2},
    {.name = "places.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 128,
        .element_bytes = sizeof(uint), .parameter = 5, .reach = glift::Reach::range},
};
constexpr glift::Parameter list_there_d62ad97a_parameters[] = {
    {"a_frames_n", 0, sizeof(list_there_d62ad97a_direct_parameters::a_frames_n)},
    {"a_data_extent", 4, sizeof(list_there_d62ad97a_direct_parameters::a_data_extent)},
    {"counter_extent_value_0", 8, sizeof(list_there_d62ad97a_direct_parameters::counter_extent_value_0)},
    {"addresses_extent", 12, sizeof(list_there_d62ad97a_direct_parameters::addresses_extent)},
    {"values_extent", 16, sizeof(list_there_d62ad97a_direct_parameters::values_extent)},
    {"translated_frames_n", 20, sizeof(list_there_d62ad97a_direct_parameters::translated_frames_n)},
    {"translated_data_extent", 24, sizeof(list_there_d62ad97a_direct_parameters::translated_data_extent)},
    {"places_extent", 28, sizeof(list_there_d62ad97a_direct_parameters::places_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel list_there_d62ad97a_kernel;
const glift::Kernel list_there_d62ad97a_kernel = {
    .name = "list_there",
    .file = "transfer.glift",
    .line = 32,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = list_there_d62ad97a_bindings,
    .direct = {.host = &list_there_d62ad97a_direct, .parameter_bytes = 32, .push_constants = true},
    .general = {.host = &list_there_d62ad97a_general, .parameter_bytes = 64},
    .wide = {.host = &list_there_d62ad97a_wide, .parameter_bytes = 136},
    .parameters = list_there_d62ad97a_parameters,
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Frames, Box<1, uint>>

namespace {
struct read_box_c62e930d_direct_parameters {
    uint from_n;
};
static_assert(offsetof(read_box_c62e930d_direct_parameters, from_n) == 0);

// transfer.glift:15: runs kernel read_box<Frames, Box<1, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_c62e930d_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            const uint* from_data_row = glift::host::row_pointer(from_data + address);
            uint* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:16
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void read_box_c62e930d_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_c62e930d_direct_rows(call, rows); });
}

struct read_box_c62e930d_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(read_box_c62e930d_general_parameters, size) == 0);
static_assert(offsetof(read_box_c62e930d_general_parameters, from_origin) == 4);
static_assert(offsetof(read_box_c62e930d_general_parameters, to_origin) == 8);

// transfer.glift:15: runs kernel read_box<Frames, Box<1, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_c62e930d_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_c62e930d_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // transfer.glift:16
            const uint from_address = from_origin + address;
            const uint to_address = to_origin + address;
            const uint* from_data_row = glift::host::row_pointer(from_data + from_address);
            uint* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:16
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void read_box_c62e930d_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_c62e930d_general_rows(call,
        rows); });
}

struct read_box_c62e930d_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(read_box_c62e930d_wide_parameters, size) == 0);
static_assert(offsetof(read_box_c62e930d_wide_parameters, from_origin) == 4);
static_assert(offsetof(read_box_c62e930d_wide_parameters, to_origin) == 8);
static_assert(offsetof(read_box_c62e930d_wide_parameters, from_data_address) == 16);
static_assert(offsetof(read_box_c62e930d_wide_parameters, to_data_address) == 24);

// transfer.glift:15: runs kernel read_box<Frames, Box<1, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void read_box_c62e930d_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_c62e930d_wide_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:16
            const uint from_address = from_origin + address;
            const uint to_address = to_origin + address;
            // transfer.glift:15
            const std::uint64_t to_at = std::uint64_t(to_address);
            // transfer.glift:16
            to_data[to_at] = from_data[std::uint64_t(from_address)];
        }
    }
}

static void read_box_c62e930d_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_c62e930d_wide_rows(call, rows); });
}

const glift::Binding read_box_c62e930d_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .element_bytes = sizeof(uint), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter read_box_c62e930d_parameters[] = {
    {"from_n", 0, sizeof(read_box_c62e930d_direct_parameters::from_n)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel read_box_c62e930d_kernel;
const glift::Kernel read_box_c62e930d_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = read_box_c62e930d_bindings,
    .direct = {.host = &read_box_c62e930d_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &read_box_c62e930d_general, .parameter_bytes = 12},
    .wide = {.host = &read_box_c62e930d_wide, .parameter_bytes = 32},
    .parameters = read_box_c62e930d_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<1, uint>, Frames>

namespace {
struct write_box_32448ca0_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(write_box_32448ca0_direct_parameters, from_extent) == 0);

// transfer.glift:20: runs kernel write_box<Box<1, uint>, Frames> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_32448ca0_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            const uint* from_data_row = glift::host::row_pointer(from_data + address);
            uint* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:21
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void write_box_32448ca0_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_32448ca0_direct_rows(call,
        rows); });
}

struct write_box_32448ca0_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(write_box_32448ca0_general_parameters, size) == 0);
static_assert(offsetof(write_box_32448ca0_general_parameters, from_origin) == 4);
static_assert(offsetof(write_box_32448ca0_general_parameters, to_origin) == 8);

// transfer.glift:20: runs kernel write_box<Box<1, uint>, Frames> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_32448ca0_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_32448ca0_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // transfer.glift:21
            const uint from_address = from_origin + address;
            const uint to_address = to_origin + address;
            const uint* from_data_row = glift::host::row_pointer(from_data + from_address);
            uint* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:21
                to_data_row[i] = from_data_row[i];
            }
        }
    }
}

static void write_box_32448ca0_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_32448ca0_general_rows(call,
        rows); });
}

struct write_box_32448ca0_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(write_box_32448ca0_wide_parameters, size) == 0);
static_assert(offsetof(write_box_32448ca0_wide_parameters, from_origin) == 4);
static_assert(offsetof(write_box_32448ca0_wide_parameters, to_origin) == 8);
static_assert(offsetof(write_box_32448ca0_wide_parameters, from_data_address) == 16);
static_assert(offsetof(write_box_32448ca0_wide_parameters, to_data_address) == 24);

// transfer.glift:20: runs kernel write_box<Box<1, uint>, Frames> for the given rows.
GLIFT_HOST_KERNEL
static void write_box_32448ca0_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_32448ca0_wide_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
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
            to_data[std::uint64_t(to_address)] = from_data[from_at];
        }
    }
}

static void write_box_32448ca0_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_32448ca0_wide_rows(call, rows); });
}

const glift::Binding write_box_32448ca0_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .element_bytes = sizeof(uint), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter write_box_32448ca0_parameters[] = {
    {"from_extent", 0, sizeof(write_box_32448ca0_direct_parameters::from_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel write_box_32448ca0_kernel;
const glift::Kernel write_box_32448ca0_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = write_box_32448ca0_bindings,
    .direct = {.host = &write_box_32448ca0_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &write_box_32448ca0_general, .parameter_bytes = 12},
    .wide = {.host = &write_box_32448ca0_wide, .parameter_bytes = 32},
    .parameters = write_box_32448ca0_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Frames, uint>

namespace {
struct fill_box_frames_Frames_uint_direct_parameters {
    uint to_n;
    uint value;
};
static_assert(offsetof(fill_box_frames_Frames_uint_direct_parameters, to_n) == 0);
static_assert(offsetof(fill_box_frames_Frames_uint_direct_parameters, value) == 4);

// transfer.glift:25: runs kernel fill_box<Frames, uint> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_frames_Frames_uint_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_frames_Frames_uint_direct_parameters*>(call.parameters);
    const uint value = parameters.value;
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            uint* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:26
                to_data_row[i] = value;
            }
        }
    }
}

static void fill_box_frames_Frames_uint_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_frames_Frames_uint_direct_rows(call,
        rows); });
}

struct fill_box_frames_Frames_uint_general_parameters {
    uint size;
    uint to_origin;
    uint value;
};
static_assert(offsetof(fill_box_frames_Frames_uint_general_parameters, size) == 0);
static_assert(offsetof(fill_box_frames_Frames_uint_general_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_frames_Frames_uint_general_parameters, value) == 8);

// transfer.glift:25: runs kernel fill_box<Frames, uint> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_frames_Frames_uint_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_frames_Frames_uint_general_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    const uint value = parameters.value;
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // transfer.glift:26
            const uint to_address = to_origin + address;
            uint* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // transfer.glift:26
                to_data_row[i] = value;
            }
        }
    }
}

static void fill_box_frames_Frames_uint_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_frames_Frames_uint_general_rows(call,
        rows); });
}

struct fill_box_frames_Frames_uint_wide_parameters {
    uint size;
    uint to_origin;
    uint value;
    std::uint64_t to_data_address;
};
static_assert(offsetof(fill_box_frames_Frames_uint_wide_parameters, size) == 0);
static_assert(offsetof(fill_box_frames_Frames_uint_wide_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_frames_Frames_uint_wide_parameters, value) == 8);
static_assert(offsetof(fill_box_frames_Frames_uint_wide_parameters, to_data_address) == 16);

// transfer.glift:25: runs kernel fill_box<Frames, uint> for the given rows.
GLIFT_HOST_KERNEL
static void fill_box_frames_Frames_uint_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_frames_Frames_uint_wide_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    const uint value = parameters.value;
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:26
            const uint to_address = to_origin + address;
            to_data[std::uint64_t(to_address)] = value;
        }
    }
}

static void fill_box_frames_Frames_uint_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_frames_Frames_uint_wide_rows(call,
        rows); });
}

const glift::Binding fill_box_frames_Frames_uint_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 16,
        .element_bytes = sizeof(uint)},
};
constexpr glift::Parameter fill_box_frames_Frames_uint_parameters[] = {
    {"to_n", 0, sizeof(fill_box_frames_Frames_uint_direct_parameters::to_n)},
    {"value", 4, sizeof(fill_box_frames_Frames_uint_direct_parameters::value)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel fill_box_frames_Frames_uint_kernel;
const glift::Kernel fill_box_frames_Frames_uint_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = fill_box_frames_Frames_uint_bindings,
    .direct = {.host = &fill_box_frames_Frames_uint_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &fill_box_frames_Frames_uint_general, .parameter_bytes = 12},
    .wide = {.host = &fill_box_frames_Frames_uint_wide, .parameter_bytes = 24},
    .parameters = fill_box_frames_Frames_uint_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:32: list_there<Frames, Frames, Box<1, uint>, Box<1, uint>, Box<1, uint>, Box<1, uint>>

namespace {
struct list_there_ba0d4190_direct_parameters {
    uint a_n;
    glift::Bool counter_extent_value_0;
    uint addresses_extent;
    uint values_extent;
    uint translated_n;
    uint places_extent;
};
static_assert(offsetof(list_there_ba0d4190_direct_parameters, a_n) == 0);
static_assert(offsetof(list_there_ba0d4190_direct_parameters, counter_extent_value_0) == 4);
static_assert(offsetof(list_there_ba0d4190_direct_parameters, addresses_extent) == 8);
static_assert(offsetof(list_there_ba0d4190_direct_parameters, values_extent) == 12);
static_assert(offsetof(list_there_ba0d4190_direct_parameters, translated_n) == 16);
static_assert(offsetof(list_there_ba0d4190_direct_parameters, places_extent) == 20);

// transfer.glift:32: runs kernel list_there<Frames, Frames, Box<1, uint>, Box<1, uint>, Box<1, uint>, Box<1, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void list_there_ba0d4190_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const list_there_ba0d4190_direct_parameters*>(call.parameters);
    const bool counter_extent_value_0 = parameters.counter_extent_value_0;
    const uint addresses_extent = parameters.addresses_extent;
    const uint values_extent = parameters.values_extent;
    const uint translated_n = parameters.translated_n;
    const uint places_extent = parameters.places_extent;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* counter_data = glift::host::elements<uint>(call.memories[1]);
    uint* addresses_data = glift::host::elements<uint>(call.memories[2]);
    uint* values_data = glift::host::elements<uint>(call.memories[3]);
    uint* places_data = glift::host::elements<uint>(call.memories[4]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            const uint* from_data_row = glift::host::row_pointer(from_data + address);
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint address = row.begin + static_cast<uint>(i);
                // transfer.glift:36
                uint result{};
                bool found{};
                const uint from_value = from_data_row[i];
                result = from_value;
                found = true;
                const uint found_2 = result;
                const bool found_found = found;
                if (found_found) {
                    // transfer.glift:37
                    uint counter_before = 0u;
                    if (counter_extent_value_0) {
                        counter_before = glift::host::memory::atomicAdd(counter_data[0u], 1u);
                    }
                    const uint entry = counter_before;
                    // transfer.glift:38
                    if (entry < addresses_extent) {
                        addresses_data[entry] = address;
                    }
                    // transfer.glift:39
                    if (entry < values_extent) {
                        values_data[entry] = found_2;
                    }
                    // transfer.glift:40
                    const bool found_found_2 = address < translated_n;
                    if (found_found_2) {
                        // transfer.glift:41
                        if (entry < places_extent) {
                            places_data[entry] = address;
                        }
                    }
                }
            }
        }
    }
}

static void list_there_ba0d4190_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { list_there_ba0d4190_direct_rows(call,
        rows); });
}

struct list_there_ba0d4190_general_parameters {
    uint size;
    uint a_origin;
    uint from_origin;
    uint from_size;
    uint counter_origin;
    uint counter_size;
    uint addresses_origin;
    uint addresses_size;
    uint values_origin;
    uint values_size;
    uint translated_origin;
    uint translated_size;
    uint places_origin;
    uint places_size;
};
static_assert(offsetof(list_there_ba0d4190_general_parameters, size) == 0);
static_assert(offsetof(list_there_ba0d4190_general_parameters, a_origin) == 4);
static_assert(offsetof(list_there_ba0d4190_general_parameters, from_origin) == 8);
static_assert(offsetof(list_there_ba0d4190_general_parameters, from_size) == 12);
static_assert(offsetof(list_there_ba0d4190_general_parameters, counter_origin) == 16);
static_assert(offsetof(list_there_ba0d4190_general_parameters, counter_size) == 20);
static_assert(offsetof(list_there_ba0d4190_general_parameters, addresses_origin) == 24);
static_assert(offsetof(list_there_ba0d4190_general_parameters, addresses_size) == 28);
static_assert(offsetof(list_there_ba0d4190_general_parameters, values_origin) == 32);
static_assert(offsetof(list_there_ba0d4190_general_parameters, values_size) == 36);
static_assert(offsetof(list_there_ba0d4190_general_parameters, translated_origin) == 40);
static_assert(offsetof(list_there_ba0d4190_general_parameters, translated_size) == 44);
static_assert(offsetof(list_there_ba0d4190_general_parameters, places_origin) == 48);
static_assert(offsetof(list_there_ba0d4190_general_parameters, places_size) == 52);

// transfer.glift:32: runs kernel list_there<Frames, Frames, Box<1, uint>, Box<1, uint>, Box<1, uint>, Box<1, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void list_there_ba0d4190_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const list_there_ba0d4190_general_parameters*>(call.parameters);
    const uint a_origin = parameters.a_origin;
    const uint from_origin = parameters.from_origin;
    const uint from_size = parameters.from_size;
    const uint counter_origin = parameters.counter_origin;
    const uint counter_size = parameters.counter_size;
    const uint addresses_origin = parameters.addresses_origin;
    const uint addresses_size = parameters.addresses_size;
    const uint values_origin = parameters.values_origin;
    const uint values_size = parameters.values_size;
    const uint translated_origin = parameters.translated_origin;
    const uint translated_size = parameters.translated_size;
    const uint places_origin = parameters.places_origin;
    const uint places_size = parameters.places_size;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* counter_data = glift::host::elements<uint>(call.memories[1]);
    uint* addresses_data = glift::host::elements<uint>(call.memories[2]);
    uint* values_data = glift::host::elements<uint>(call.memories[3]);
    uint* places_data = glift::host::elements<uint>(call.memories[4]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:36
            const uint a_address = a_origin + address;
            uint result{};
            bool found{};
            if (a_address < from_size) {
                const uint from_virtual = from_origin + a_address;
                const uint from_value = from_data[from_virtual];
                result = from_value;
                found = true;
            } else {
                result = 0u;
                found = false;
            }
            const uint found_2 = result;
            const bool found_found = found;
            if (found_found) {
                // transfer.glift:37
                uint counter_before = 0u;
                if (0u < counter_size) {
                    counter_before = glift::host::memory::atomicAdd(counter_data[counter_origin], 1u);
                }
                const uint entry = counter_before;
                // transfer.glift:38
                const uint addresses_virtual = addresses_origin + entry;
                if (entry < addresses_size) {
                    addresses_data[addresses_virtual] = a_address;
                }
                // transfer.glift:39
                const uint values_virtual = values_origin + entry;
                if (entry < values_size) {
                    values_data[values_virtual] = found_2;
                }
                // transfer.glift:40
                const uint found_3 = translated_origin + a_address;
                const bool found_found_2 = a_address < translated_size;
                if (found_found_2) {
                    // transfer.glift:41
                    const uint places_virtual = places_origin + entry;
                    if (entry < places_size) {
                        places_data[places_virtual] = found_3;
                    }
                }
            }
        }
    }
}

static void list_there_ba0d4190_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { list_there_ba0d4190_general_rows(call,
        rows); });
}

struct list_there_ba0d4190_wide_parameters {
    uint size;
    uint a_origin;
    uint from_origin;
    uint from_size;
    uint counter_origin;
    uint counter_size;
    uint addresses_origin;
    uint addresses_size;
    uint values_origin;
    uint values_size;
    uint translated_origin;
    uint translated_size;
    uint places_origin;
    uint places_size;
    std::uint64_t from_data_address;
    std::uint64_t counter_data_address;
    std::uint64_t addresses_data_address;
    std::uint64_t values_data_address;
    std::uint64_t places_data_address;
};
static_assert(offsetof(list_there_ba0d4190_wide_parameters, size) == 0);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, a_origin) == 4);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, from_origin) == 8);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, from_size) == 12);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, counter_origin) == 16);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, counter_size) == 20);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, addresses_origin) == 24);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, addresses_size) == 28);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, values_origin) == 32);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, values_size) == 36);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, translated_origin) == 40);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, translated_size) == 44);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, places_origin) == 48);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, places_size) == 52);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, from_data_address) == 56);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, counter_data_address) == 64);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, addresses_data_address) == 72);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, values_data_address) == 80);
static_assert(offsetof(list_there_ba0d4190_wide_parameters, places_data_address) == 88);

// transfer.glift:32: runs kernel list_there<Frames, Frames, Box<1, uint>, Box<1, uint>, Box<1, uint>, Box<1, uint>> for the given rows.
GLIFT_HOST_KERNEL
static void list_there_ba0d4190_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const list_there_ba0d4190_wide_parameters*>(call.parameters);
    const uint a_origin = parameters.a_origin;
    const uint from_origin = parameters.from_origin;
    const uint from_size = parameters.from_size;
    const uint counter_origin = parameters.counter_origin;
    const uint counter_size = parameters.counter_size;
    const uint addresses_origin = parameters.addresses_origin;
    const uint addresses_size = parameters.addresses_size;
    const uint values_origin = parameters.values_origin;
    const uint values_size = parameters.values_size;
    const uint translated_origin = parameters.translated_origin;
    const uint translated_size = parameters.translated_size;
    const uint places_origin = parameters.places_origin;
    const uint places_size = parameters.places_size;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* counter_data = glift::host::elements<uint>(call.memories[1]);
    uint* addresses_data = glift::host::elements<uint>(call.memories[2]);
    uint* values_data = glift::host::elements<uint>(call.memories[3]);
    uint* places_data = glift::host::elements<uint>(call.memories[4]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // transfer.glift:36
            const uint a_address = a_origin + address;
            uint result{};
            bool found{};
            if (a_address < from_size) {
                const uint from_virtual = from_origin + a_address;
                const uint from_value = from_data[std::uint64_t(from_virtual)];
                result = from_value;
                found = true;
            } else {
                result = 0u;
                found = false;
            }
            const uint found_2 = result;
            const bool found_found = found;
            if (found_found) {
                // transfer.glift:37
                uint counter_before = 0u;
                if (0u < counter_size) {
                    counter_before = glift::host::memory::atomicAdd(counter_data[std::uint64_t(counter_origin)], 1u);
                }
                const uint entry = counter_before;
                // transfer.glift:38
                const uint addresses_virtual = addresses_origin + entry;
                if (entry < addresses_size) {
                    addresses_data[std::uint64_t(addresses_virtual)] = a_address;
                }
                // transfer.glift:39
                const uint values_virtual = values_origin + entry;
                if (entry < values_size) {
                    values_data[std::uint64_t(values_virtual)] = found_2;
                }
                // transfer.glift:40
                const uint found_3 = translated_origin + a_address;
                const bool found_found_2 = a_address < translated_size;
                if (found_found_2) {
                    // transfer.glift:41
                    const uint places_virtual = places_origin + entry;
                    if (entry < places_size) {
                        places_data[std::uint64_t(places_virtual)] = found_3;
                    }
                }
            }
        }
    }
}

static void list_there_ba0d4190_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { list_there_ba0d4190_wide_rows(call, rows); });
}

const glift::Binding list_there_ba0d4190_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 56,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::range},
    {.name = "counter.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read_write,
        .address_offset = 64, .element_bytes = sizeof(uint), .parameter = 3, .reach = glift::Reach::range,
        .combine = glift::Combine::coherent},
    {.name = "addresses.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 72,
        .element_bytes = sizeof(uint), .parameter = 4, .reach = glift::Reach::range},
    {.name = "values.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 80,
        .element_bytes = sizeof(uint), .parameter = 6, .reach = glift::Reach::range},
    {.name = "places.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 88,
        .element_bytes = sizeof(uint), .parameter = 5, .reach = glift::Reach::range},
};
constexpr glift::Parameter list_there_ba0d4190_parameters[] = {
    {"a_n", 0, sizeof(list_there_ba0d4190_direct_parameters::a_n)},
    {"counter_extent_value_0", 4, sizeof(list_there_ba0d4190_direct_parameters::counter_extent_value_0)},
    {"addresses_extent", 8, sizeof(list_there_ba0d4190_direct_parameters::addresses_extent)},
    {"values_extent", 12, sizeof(list_there_ba0d4190_direct_parameters::values_extent)},
    {"translated_n", 16, sizeof(list_there_ba0d4190_direct_parameters::translated_n)},
    {"places_extent", 20, sizeof(list_there_ba0d4190_direct_parameters::places_extent)},
};
}  // namespace

extern GLIFT_SHARED const glift::Kernel list_there_ba0d4190_kernel;
const glift::Kernel list_there_ba0d4190_kernel = {
    .name = "list_there",
    .file = "transfer.glift",
    .line = 32,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = list_there_ba0d4190_bindings,
    .direct = {.host = &list_there_ba0d4190_direct, .parameter_bytes = 24, .push_constants = true},
    .general = {.host = &list_there_ba0d4190_general, .parameter_bytes = 56},
    .wide = {.host = &list_there_ba0d4190_wide, .parameter_bytes = 96},
    .parameters = list_there_ba0d4190_parameters,
};

}  // namespace std_transfer

