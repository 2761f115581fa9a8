// Made by gliftc from frames.glift. Changes are lost when it is made again.
#include "frames.glift.hpp"

#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>

#include <optional>

namespace frames {

using namespace glift::types;

namespace {

/// Elements of a box in a linear buffer, first axis fastest: what the host reads and writes.
class Box_1_float : public glift::Structure<Box_1_float, uint, float> {
public:
    static constexpr const char* type_name = "Box<1, float>";

    Box_1_float() = default;
    [[maybe_unused]] Box_1_float(const glift::Commands& commands, uint extent);
    /// Over parts that exist already.
    [[maybe_unused]] Box_1_float(const glift::Commands& commands, uint extent, glift::Memory data);

    /// The extent of the virtual domain.
    [[maybe_unused]] uint domain() const;
    uint extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    uint data_extent() const { return data_extent_; }
    /// True if the two were made with equal arguments.
    [[maybe_unused]] bool same_state(const Box_1_float& other) const;

private:
    uint extent_{};
    uint data_extent_{};
    glift::Memory data_;
};

// address.glift:17: volume<1>
inline uint volume(uint extent) {
    // address.glift:18
    uint product = extent;
    // address.glift:19
    for (uint axis = 1u; axis < 1u; ++axis) {
        // address.glift:20
        product *= extent;
    }
    // address.glift:22
    return product;
}

// ----------------------------------------------------------------------------------------------------
// frames.glift:34: double_there

struct double_there_direct_parameters {
    uint s_frames_n;
    uint s_data_extent;
};
static_assert(offsetof(double_there_direct_parameters, s_frames_n) == 0);
static_assert(offsetof(double_there_direct_parameters, s_data_extent) == 4);

// frames.glift:34: double_there, some rows.
GLIFT_HOST_KERNEL
static void double_there_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const double_there_direct_parameters*>(call.parameters);
    const uint s_frames_n = parameters.s_frames_n;
    const uint s_data_extent = parameters.s_data_extent;
    const uint* g_frames_data = glift::host::elements<const uint>(call.memories[0]);
    float* g_data = glift::host::elements<float>(call.memories[1]);
    const uint* s_frames_data = glift::host::elements<const uint>(call.memories[2]);
    const float* s_data = glift::host::elements<const float>(call.memories[3]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // frames.glift:34
            const uint g_frames_address = address / 4u;
            const bool g_frames_value_inside = g_frames_address < s_frames_n;
            const uint g_frames_value = g_frames_data[g_frames_value_inside ? g_frames_address : 0u];
            const uint g_frames_value_2 = g_frames_value_inside ? g_frames_value : 0u;
            const uint g_place = (g_frames_value_2 - 1u) * 4u + address % 4u;
            const bool g_found = !(g_frames_value_2 == 0u) && g_place < s_data_extent;
            const float g_value = g_data[g_found ? g_place : 0u];
            const float g_value_2 = g_found ? g_value : -1.0f;
            const uint s_address = address + 1u;
            const uint s_frames_address = s_address / 4u;
            const bool s_frames_value_inside = s_frames_address < s_frames_n;
            const uint s_frames_value = s_frames_data[s_frames_value_inside ? s_frames_address : 0u];
            const uint s_frame = s_frames_value_inside ? s_frames_value : 0u;
            const uint s_place = (s_frame - 1u) * 4u + s_address % 4u;
            const bool s_value_inside = !(s_frame == 0u) && s_place < s_data_extent;
            const float s_value = s_data[s_value_inside ? s_place : 0u];
            if (g_found) {
                g_data[g_place] = g_value_2 + (s_value_inside ? s_value : -1.0f);
            }
        }
    }
}

static void double_there_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { double_there_direct_rows(call, rows); });
}

struct double_there_general_parameters {
    uint size;
    uint g_origin;
    uint s_origin;
    uint g_frames_n;
    uint g_data_extent;
    uint s_frames_n;
    uint s_data_extent;
};
static_assert(offsetof(double_there_general_parameters, size) == 0);
static_assert(offsetof(double_there_general_parameters, g_origin) == 4);
static_assert(offsetof(double_there_general_parameters, s_origin) == 8);
static_assert(offsetof(double_there_general_parameters, g_frames_n) == 12);
static_assert(offsetof(double_there_general_parameters, g_data_extent) == 16);
static_assert(offsetof(double_there_general_parameters, s_frames_n) == 20);
static_assert(offsetof(double_there_general_parameters, s_data_extent) == 24);

// frames.glift:34: double_there, some rows.
GLIFT_HOST_KERNEL
static void double_there_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const double_there_general_parameters*>(call.parameters);
    const uint g_origin = parameters.g_origin;
    const uint s_origin = parameters.s_origin;
    const uint g_frames_n = parameters.g_frames_n;
    const uint g_data_extent = parameters.g_data_extent;
    const uint s_frames_n = parameters.s_frames_n;
    const uint s_data_extent = parameters.s_data_extent;
    const uint* g_frames_data = glift::host::elements<const uint>(call.memories[0]);
    float* g_data = glift::host::elements<float>(call.memories[1]);
    const uint* s_frames_data = glift::host::elements<const uint>(call.memories[2]);
    const float* s_data = glift::host::elements<const float>(call.memories[3]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // frames.glift:34
            const uint g_address = g_origin + address;
            const uint g_frames_address = g_address / 4u;
            const bool g_frames_value_inside = g_frames_address < g_frames_n;
            const uint g_frames_value = g_frames_data[g_frames_value_inside ? g_frames_address : 0u];
            const uint g_frames_value_2 = g_frames_value_inside ? g_frames_value : 0u;
            const uint g_place = (g_frames_value_2 - 1u) * 4u + g_address % 4u;
            const bool g_found = !(g_frames_value_2 == 0u) && g_place < g_data_extent;
            const float g_value = g_data[g_found ? g_place : 0u];
            const float g_value_2 = g_found ? g_value : -1.0f;
            const uint s_address = address + 1u;
            const uint s_virtual = s_origin + s_address;
            const uint s_frames_address = s_virtual / 4u;
            const bool s_frames_value_inside = s_frames_address < s_frames_n;
            const uint s_frames_value = s_frames_data[s_frames_value_inside ? s_frames_address : 0u];
            const uint s_frame = s_frames_value_inside ? s_frames_value : 0u;
            const uint s_place = (s_frame - 1u) * 4u + s_virtual % 4u;
            const bool s_value_inside = !(s_frame == 0u) && s_place < s_data_extent;
            const float s_value = s_data[s_value_inside ? s_place : 0u];
            if (g_found) {
                g_data[g_place] = g_value_2 + (s_value_inside ? s_value : -1.0f);
            }
        }
    }
}

static void double_there_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { double_there_general_rows(call, rows); });
}

const glift::Binding double_there_bindings[] = {
    {.name = "g.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 32},
    {.name = "g.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read_write, .address_offset = 40},
    {.name = "s.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 48},
    {.name = "s.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 56},
};
constexpr glift::Parameter double_there_parameters[] = {
    {"s_frames_n", 0, sizeof(double_there_direct_parameters::s_frames_n)},
    {"s_data_extent", 4, sizeof(double_there_direct_parameters::s_data_extent)},
};
const glift::Kernel double_there_kernel = {
    .name = "double_there",
    .file = "frames.glift",
    .line = 34,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = double_there_bindings,
    .direct = {.host = &double_there_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &double_there_general, .parameter_bytes = 28},
    .wide = {},
    .parameters = double_there_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Pool, Box<1, float>>

struct read_box_direct_parameters {
    uint from_frames_n;
    uint from_data_extent;
};
static_assert(offsetof(read_box_direct_parameters, from_frames_n) == 0);
static_assert(offsetof(read_box_direct_parameters, from_data_extent) == 4);

// transfer.glift:15: read_box<Pool, Box<1, float>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_direct_parameters*>(call.parameters);
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

static void read_box_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_direct_rows(call, rows); });
}

struct read_box_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    uint from_frames_n;
    uint from_data_extent;
};
static_assert(offsetof(read_box_general_parameters, size) == 0);
static_assert(offsetof(read_box_general_parameters, from_origin) == 4);
static_assert(offsetof(read_box_general_parameters, to_origin) == 8);
static_assert(offsetof(read_box_general_parameters, from_frames_n) == 12);
static_assert(offsetof(read_box_general_parameters, from_data_extent) == 16);

// transfer.glift:15: read_box<Pool, Box<1, float>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_general_parameters*>(call.parameters);
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

static void read_box_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_general_rows(call, rows); });
}

const glift::Binding read_box_bindings[] = {
    {.name = "from.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read,
        .address_offset = 24},
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 32},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 40},
};
constexpr glift::Parameter read_box_parameters[] = {
    {"from_frames_n", 0, sizeof(read_box_direct_parameters::from_frames_n)},
    {"from_data_extent", 4, sizeof(read_box_direct_parameters::from_data_extent)},
};
const glift::Kernel read_box_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = read_box_bindings,
    .direct = {.host = &read_box_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &read_box_general, .parameter_bytes = 20},
    .wide = {},
    .parameters = read_box_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<1, float>, Pool>

struct write_box_direct_parameters {
    uint from_extent;
    uint to_frames_n;
    uint to_data_extent;
};
static_assert(offsetof(write_box_direct_parameters, from_extent) == 0);
static_assert(offsetof(write_box_direct_parameters, to_frames_n) == 4);
static_assert(offsetof(write_box_direct_parameters, to_data_extent) == 8);

// transfer.glift:20: write_box<Box<1, float>, Pool>, some rows.
GLIFT_HOST_KERNEL
static void write_box_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_direct_parameters*>(call.parameters);
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
            const uint to_frames_value_2 = to_frames_value_inside ? to_frames_value : 0u;
            const uint to_place = (to_frames_value_2 - 1u) * 4u + address % 4u;
            const bool to_found = !(to_frames_value_2 == 0u) && to_place < to_data_extent;
            // transfer.glift:21
            if (to_found) {
                to_data[to_place] = from_data[address];
            }
        }
    }
}

static void write_box_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_direct_rows(call, rows); });
}

struct write_box_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    uint to_frames_n;
    uint to_data_extent;
};
static_assert(offsetof(write_box_general_parameters, size) == 0);
static_assert(offsetof(write_box_general_parameters, from_origin) == 4);
static_assert(offsetof(write_box_general_parameters, to_origin) == 8);
static_assert(offsetof(write_box_general_parameters, to_frames_n) == 12);
static_assert(offsetof(write_box_general_parameters, to_data_extent) == 16);

// transfer.glift:20: write_box<Box<1, float>, Pool>, some rows.
GLIFT_HOST_KERNEL
static void write_box_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_general_parameters*>(call.parameters);
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
            const uint to_frames_value_2 = to_frames_value_inside ? to_frames_value : 0u;
            const uint to_place = (to_frames_value_2 - 1u) * 4u + to_address % 4u;
            const bool to_found = !(to_frames_value_2 == 0u) && to_place < to_data_extent;
            // transfer.glift:21
            if (to_found) {
                to_data[to_place] = from_data[from_address];
            }
        }
    }
}

static void write_box_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_general_rows(call, rows); });
}

const glift::Binding write_box_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24},
    {.name = "to.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 32},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 40},
};
constexpr glift::Parameter write_box_parameters[] = {
    {"from_extent", 0, sizeof(write_box_direct_parameters::from_extent)},
    {"to_frames_n", 4, sizeof(write_box_direct_parameters::to_frames_n)},
    {"to_data_extent", 8, sizeof(write_box_direct_parameters::to_data_extent)},
};
const glift::Kernel write_box_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = write_box_bindings,
    .direct = {.host = &write_box_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &write_box_general, .parameter_bytes = 20},
    .wide = {},
    .parameters = write_box_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Pool, float>

struct fill_box_direct_parameters {
    uint to_frames_n;
    uint to_data_extent;
    float value;
};
static_assert(offsetof(fill_box_direct_parameters, to_frames_n) == 0);
static_assert(offsetof(fill_box_direct_parameters, to_data_extent) == 4);
static_assert(offsetof(fill_box_direct_parameters, value) == 8);

// transfer.glift:25: fill_box<Pool, float>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_direct_parameters*>(call.parameters);
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
            const uint to_frames_value_2 = to_frames_value_inside ? to_frames_value : 0u;
            const uint to_place = (to_frames_value_2 - 1u) * 4u + address % 4u;
            const bool to_found = !(to_frames_value_2 == 0u) && to_place < to_data_extent;
            // transfer.glift:26
            if (to_found) {
                to_data[to_place] = value;
            }
        }
    }
}

static void fill_box_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_direct_rows(call, rows); });
}

struct fill_box_general_parameters {
    uint size;
    uint to_origin;
    uint to_frames_n;
    uint to_data_extent;
    float value;
};
static_assert(offsetof(fill_box_general_parameters, size) == 0);
static_assert(offsetof(fill_box_general_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_general_parameters, to_frames_n) == 8);
static_assert(offsetof(fill_box_general_parameters, to_data_extent) == 12);
static_assert(offsetof(fill_box_general_parameters, value) == 16);

// transfer.glift:25: fill_box<Pool, float>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_general_parameters*>(call.parameters);
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
            const uint to_frames_value_2 = to_frames_value_inside ? to_frames_value : 0u;
            const uint to_place = (to_frames_value_2 - 1u) * 4u + to_address % 4u;
            const bool to_found = !(to_frames_value_2 == 0u) && to_place < to_data_extent;
            // transfer.glift:26
            if (to_found) {
                to_data[to_place] = value;
            }
        }
    }
}

static void fill_box_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_general_rows(call, rows); });
}

const glift::Binding fill_box_bindings[] = {
    {.name = "to.frames.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 32},
};
constexpr glift::Parameter fill_box_parameters[] = {
    {"to_frames_n", 0, sizeof(fill_box_direct_parameters::to_frames_n)},
    {"to_data_extent", 4, sizeof(fill_box_direct_parameters::to_data_extent)},
    {"value", 8, sizeof(fill_box_direct_parameters::value)},
};
const glift::Kernel fill_box_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = fill_box_bindings,
    .direct = {.host = &fill_box_direct, .parameter_bytes = 12, .push_constants = true},
    .general = {.host = &fill_box_general, .parameter_bytes = 20},
    .wide = {},
    .parameters = fill_box_parameters,
    .items = {2, 1, 1},
};

void read_box(const glift::Commands& commands, const glift::Range<Pool>& from, const glift::Range<Box_1_float>& to) {
    glift::Iteration iteration(read_box_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->frames().data(), from->data(), to->data()};
    if (iteration.is_whole() && !commands.needs_general(read_box_kernel, memories, iteration.size())) {
        const read_box_direct_parameters parameters = {
            .from_frames_n = from->frames().n(),
            .from_data_extent = from->data_extent(),
        };
        commands.dispatch(read_box_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const read_box_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_frames_n = from->frames().n(),
            .from_data_extent = from->data_extent(),
        };
        commands.dispatch(read_box_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(read_box_general_parameters, size)})});
    }
}

void write_box(const glift::Commands& commands, const glift::Range<Box_1_float>& from, const glift::Range<Pool>& to) {
    glift::Iteration iteration(write_box_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->frames().data(), to->data()};
    if (iteration.is_whole() && !commands.needs_general(write_box_kernel, memories, iteration.size())) {
        const write_box_direct_parameters parameters = {
            .from_extent = from->extent(),
            .to_frames_n = to->frames().n(),
            .to_data_extent = to->data_extent(),
        };
        commands.dispatch(write_box_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const write_box_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .to_frames_n = to->frames().n(),
            .to_data_extent = to->data_extent(),
        };
        commands.dispatch(write_box_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(write_box_general_parameters, size)})});
    }
}

void fill_box(const glift::Commands& commands, const glift::Range<Pool>& to, float value) {
    glift::Iteration iteration(fill_box_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->frames().data(), to->data()};
    if (iteration.is_whole() && !commands.needs_general(fill_box_kernel, memories, iteration.size())) {
        const fill_box_direct_parameters parameters = {
            .to_frames_n = to->frames().n(),
            .to_data_extent = to->data_extent(),
            .value = value,
        };
        commands.dispatch(fill_box_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const fill_box_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .to_frames_n = to->frames().n(),
            .to_data_extent = to->data_extent(),
            .value = value,
        };
        commands.dispatch(fill_box_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(fill_box_general_parameters, size)})});
    }
}

Box_1_float::Box_1_float(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.allocate({.name = "Box_1_float.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

Box_1_float::Box_1_float(const glift::Commands& commands, uint extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Box_1_float.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

uint Box_1_float::domain() const {
    return extent_;
}

bool Box_1_float::same_state(const Box_1_float& other) const {
    return extent_ == other.extent_;
}

}  // namespace

void double_there(const glift::Commands& commands, const glift::Range<Pool>& s, const glift::Range<Pool>& g) {
    glift::Iteration iteration(double_there_kernel);
    iteration.each("g", g);
    iteration.any("s", s);
    const glift::Memory memories[] = {g->frames().data(), g->data(), s->frames().data(), s->data()};
    if (iteration.is_whole() && s->same_state(g.structure())
        && !commands.needs_general(double_there_kernel, memories, iteration.size())) {
        const double_there_direct_parameters parameters = {
            .s_frames_n = s->frames().n(),
            .s_data_extent = s->data_extent(),
        };
        commands.dispatch(double_there_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const double_there_general_parameters parameters = {
            .size = g.size(),
            .g_origin = g.origin(),
            .s_origin = s.origin(),
            .g_frames_n = g->frames().n(),
            .g_data_extent = g->data_extent(),
            .s_frames_n = s->frames().n(),
            .s_data_extent = s->data_extent(),
        };
        commands.dispatch(double_there_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(double_there_general_parameters, size)})});
    }
}

Frames::Frames(const glift::Commands& commands, uint n)
    : Structure(commands.device()),
      n_(n),
      data_extent_(n_),
      data_(commands.allocate({.name = "Frames.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

Frames::Frames(const glift::Commands& commands, uint n, glift::Memory data)
    : Structure(commands.device()),
      n_(n),
      data_extent_(n_),
      data_(commands.adopt(std::move(data),
        {.name = "Frames.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

uint Frames::domain() const {
    return n_;
}

bool Frames::same_state(const Frames& other) const {
    return n_ == other.n_;
}

Pool::Pool(const glift::Commands& commands, uint pages, uint capacity)
    : Structure(commands.device()),
      pages_(pages),
      capacity_(capacity),
      frames_(Frames(commands, pages_)),
      data_extent_(capacity_ * 4u),
      data_(commands.allocate({.name = "Pool.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

Pool::Pool(const glift::Commands& commands, uint pages, uint capacity, Frames frames, glift::Memory data)
    : Structure(commands.device()),
      pages_(pages),
      capacity_(capacity),
      frames_(glift::detail::part(std::move(frames), frames.n() == pages_, "Pool.frames")),
      data_extent_(capacity_ * 4u),
      data_(commands.adopt(std::move(data),
        {.name = "Pool.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

uint Pool::domain() const {
    return frames_.n() * 4u;
}

bool Pool::same_state(const Pool& other) const {
    return pages_ == other.pages_ && capacity_ == other.capacity_ && frames_.same_state(other.frames_);
}

void Pool::copy_out(const glift::Commands& commands, const glift::Range<Pool>& range, const glift::Memory& box) const {
    read_box(commands, range, Box_1_float(commands, range.size(), box));
}

void Pool::copy_in(const glift::Commands& commands, const glift::Range<Pool>& range, const glift::Memory& box) const {
    write_box(commands, Box_1_float(commands, range.size(), box), range);
}

void Pool::fill(float value, const glift::Range<Pool>& range) {
    fill_box(device(), range, value);
}
void Pool::fill(float value) {
    fill(value, *this);
}

}  // namespace frames
