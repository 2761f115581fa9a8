// Made by gliftc from frames.glift. Changes are lost when it is made again.
#include "frames.glift.types.hpp"

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

// transfer.glift:15: read_box<Pool, Box<1, float>>, some rows.
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

// transfer.glift:15: read_box<Pool, Box<1, float>>, some rows.
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

// transfer.glift:15: read_box<Pool, Box<1, float>>, some rows.
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
            const std::uint64_t from_place = std::uint64_t(from_frame - 1u) * std::uint64_t{4u}
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

// transfer.glift:20: write_box<Box<1, float>, Pool>, some rows.
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

// transfer.glift:20: write_box<Box<1, float>, Pool>, some rows.
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

// transfer.glift:20: write_box<Box<1, float>, Pool>, some rows.
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
            const std::uint64_t to_place = std::uint64_t(to_frame - 1u) * std::uint64_t{4u}
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

// transfer.glift:25: fill_box<Pool, float>, some rows.
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

// transfer.glift:25: fill_box<Pool, float>, some rows.
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

// transfer.glift:25: fill_box<Pool, float>, some rows.
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
            const std::uint64_t to_place = std::uint64_t(to_frame - 1u) * std::uint64_t{4u}
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

}  // namespace std_transfer

