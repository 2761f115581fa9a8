// Made by gliftc from devices.glift. Changes are lost when it is made again.
#include "devices.glift.hpp"

#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>

#include <optional>

namespace devices {

using namespace glift::types;

namespace {

/// Elements of a box in a linear buffer, first axis fastest: what the host reads and writes.
class Box_1_uint : public glift::Structure<Box_1_uint, uint, uint> {
public:
    static constexpr const char* type_name = "Box<1, uint>";

    Box_1_uint() = default;
    [[maybe_unused]] Box_1_uint(const glift::Commands& commands, uint extent);
    /// Over parts that exist already.
    [[maybe_unused]] Box_1_uint(const glift::Commands& commands, uint extent, glift::Memory data);

    /// The extent of the virtual domain.
    [[maybe_unused]] uint domain() const;
    uint extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    uint data_extent() const { return data_extent_; }
    /// True if the two were made with equal arguments.
    [[maybe_unused]] bool same_state(const Box_1_uint& other) const;

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

// address.glift:26: linearize<1>
inline uint linearize(uint address, uint extent) {
    // address.glift:27
    uint index = address;
    // address.glift:28
    for (uint back = 1u; back < 1u; ++back) {
        // address.glift:29
        index = index * extent + address;
    }
    // address.glift:31
    return index;
}

// ----------------------------------------------------------------------------------------------------
// devices.glift:8: on_any

struct on_any_direct_parameters {
    uint to_extent;
};
static_assert(offsetof(on_any_direct_parameters, to_extent) == 0);

// devices.glift:8: on_any, some rows.
GLIFT_HOST_KERNEL
static void on_any_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            uint* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // devices.glift:9
                to_data_row[i] = 1u;
            }
        }
    }
}

static void on_any_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { on_any_direct_rows(call, rows); });
}

struct on_any_general_parameters {
    uint size;
    uint to_origin;
};
static_assert(offsetof(on_any_general_parameters, size) == 0);
static_assert(offsetof(on_any_general_parameters, to_origin) == 4);

// devices.glift:8: on_any, some rows.
GLIFT_HOST_KERNEL
static void on_any_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const on_any_general_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // devices.glift:9
            const uint to_address = to_origin + address;
            uint* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // devices.glift:9
                to_data_row[i] = 1u;
            }
        }
    }
}

static void on_any_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { on_any_general_rows(call, rows); });
}

const glift::Binding on_any_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 8},
};
constexpr glift::Parameter on_any_parameters[] = {
    {"to_extent", 0, sizeof(on_any_direct_parameters::to_extent)},
};
const glift::Kernel on_any_kernel = {
    .name = "on_any",
    .file = "devices.glift",
    .line = 8,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = on_any_bindings,
    .direct = {.host = &on_any_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &on_any_general, .parameter_bytes = 8},
    .wide = {},
    .parameters = on_any_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// devices.glift:12: on_host

struct on_host_direct_parameters {
    uint to_extent;
};
static_assert(offsetof(on_host_direct_parameters, to_extent) == 0);

// devices.glift:12: on_host, some rows.
GLIFT_HOST_KERNEL
static void on_host_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            uint* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // devices.glift:13
                to_data_row[i] = 2u;
            }
        }
    }
}

static void on_host_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { on_host_direct_rows(call, rows); });
}

struct on_host_general_parameters {
    uint size;
    uint to_origin;
};
static_assert(offsetof(on_host_general_parameters, size) == 0);
static_assert(offsetof(on_host_general_parameters, to_origin) == 4);

// devices.glift:12: on_host, some rows.
GLIFT_HOST_KERNEL
static void on_host_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const on_host_general_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // devices.glift:13
            const uint to_address = to_origin + address;
            uint* to_data_row = glift::host::row_pointer(to_data + to_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // devices.glift:13
                to_data_row[i] = 2u;
            }
        }
    }
}

static void on_host_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { on_host_general_rows(call, rows); });
}

const glift::Binding on_host_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 8},
};
constexpr glift::Parameter on_host_parameters[] = {
    {"to_extent", 0, sizeof(on_host_direct_parameters::to_extent)},
};
const glift::Kernel on_host_kernel = {
    .name = "on_host",
    .file = "devices.glift",
    .line = 12,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = on_host_bindings,
    .direct = {.host = &on_host_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &on_host_general, .parameter_bytes = 8},
    .wide = {},
    .parameters = on_host_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// devices.glift:16: on_gpu

struct on_gpu_direct_parameters {
    uint to_extent;
};
static_assert(offsetof(on_gpu_direct_parameters, to_extent) == 0);

struct on_gpu_general_parameters {
    uint size;
    uint to_origin;
};
static_assert(offsetof(on_gpu_general_parameters, size) == 0);
static_assert(offsetof(on_gpu_general_parameters, to_origin) == 4);

const glift::Binding on_gpu_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 8},
};
constexpr glift::Parameter on_gpu_parameters[] = {
    {"to_extent", 0, sizeof(on_gpu_direct_parameters::to_extent)},
};
const glift::Kernel on_gpu_kernel = {
    .name = "on_gpu",
    .file = "devices.glift",
    .line = 16,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = on_gpu_bindings,
    .direct = {.parameter_bytes = 4, .push_constants = true},
    .general = {.parameter_bytes = 8},
    .wide = {},
    .parameters = on_gpu_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// devices.glift:20: on_wide_subgroups

struct on_wide_subgroups_direct_parameters {
    uint to_extent;
};
static_assert(offsetof(on_wide_subgroups_direct_parameters, to_extent) == 0);

struct on_wide_subgroups_general_parameters {
    uint size;
    uint to_origin;
};
static_assert(offsetof(on_wide_subgroups_general_parameters, size) == 0);
static_assert(offsetof(on_wide_subgroups_general_parameters, to_origin) == 4);

const glift::Binding on_wide_subgroups_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 8},
};
constexpr glift::Parameter on_wide_subgroups_parameters[] = {
    {"to_extent", 0, sizeof(on_wide_subgroups_direct_parameters::to_extent)},
};
const glift::Kernel on_wide_subgroups_kernel = {
    .name = "on_wide_subgroups",
    .file = "devices.glift",
    .line = 20,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = on_wide_subgroups_bindings,
    .direct = {.parameter_bytes = 4, .push_constants = true},
    .general = {.parameter_bytes = 8},
    .wide = {},
    .parameters = on_wide_subgroups_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// devices.glift:24: on_vulkan

struct on_vulkan_direct_parameters {
    uint to_extent;
};
static_assert(offsetof(on_vulkan_direct_parameters, to_extent) == 0);

struct on_vulkan_general_parameters {
    uint size;
    uint to_origin;
};
static_assert(offsetof(on_vulkan_general_parameters, size) == 0);
static_assert(offsetof(on_vulkan_general_parameters, to_origin) == 4);

const glift::Binding on_vulkan_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 8},
};
constexpr glift::Parameter on_vulkan_parameters[] = {
    {"to_extent", 0, sizeof(on_vulkan_direct_parameters::to_extent)},
};
const glift::Kernel on_vulkan_kernel = {
    .name = "on_vulkan",
    .file = "devices.glift",
    .line = 24,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = on_vulkan_bindings,
    .direct = {.parameter_bytes = 4, .push_constants = true},
    .general = {.parameter_bytes = 8},
    .wide = {},
    .parameters = on_vulkan_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:15: read_box<Array<1, uint, none, buffer>, Box<1, uint>>

struct read_box_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(read_box_direct_parameters, from_extent) == 0);

// transfer.glift:15: read_box<Array<1, uint, none, buffer>, Box<1, uint>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
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

static void read_box_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_direct_rows(call, rows); });
}

struct read_box_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(read_box_general_parameters, size) == 0);
static_assert(offsetof(read_box_general_parameters, from_origin) == 4);
static_assert(offsetof(read_box_general_parameters, to_origin) == 8);

// transfer.glift:15: read_box<Array<1, uint, none, buffer>, Box<1, uint>>, some rows.
GLIFT_HOST_KERNEL
static void read_box_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const read_box_general_parameters*>(call.parameters);
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

static void read_box_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { read_box_general_rows(call, rows); });
}

const glift::Binding read_box_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter read_box_parameters[] = {
    {"from_extent", 0, sizeof(read_box_direct_parameters::from_extent)},
};
const glift::Kernel read_box_kernel = {
    .name = "read_box",
    .file = "transfer.glift",
    .line = 15,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = read_box_bindings,
    .direct = {.host = &read_box_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &read_box_general, .parameter_bytes = 12},
    .wide = {},
    .parameters = read_box_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:20: write_box<Box<1, uint>, Array<1, uint, none, buffer>>

struct write_box_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(write_box_direct_parameters, from_extent) == 0);

// transfer.glift:20: write_box<Box<1, uint>, Array<1, uint, none, buffer>>, some rows.
GLIFT_HOST_KERNEL
static void write_box_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
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

static void write_box_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_direct_rows(call, rows); });
}

struct write_box_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(write_box_general_parameters, size) == 0);
static_assert(offsetof(write_box_general_parameters, from_origin) == 4);
static_assert(offsetof(write_box_general_parameters, to_origin) == 8);

// transfer.glift:20: write_box<Box<1, uint>, Array<1, uint, none, buffer>>, some rows.
GLIFT_HOST_KERNEL
static void write_box_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const write_box_general_parameters*>(call.parameters);
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

static void write_box_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { write_box_general_rows(call, rows); });
}

const glift::Binding write_box_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter write_box_parameters[] = {
    {"from_extent", 0, sizeof(write_box_direct_parameters::from_extent)},
};
const glift::Kernel write_box_kernel = {
    .name = "write_box",
    .file = "transfer.glift",
    .line = 20,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = write_box_bindings,
    .direct = {.host = &write_box_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &write_box_general, .parameter_bytes = 12},
    .wide = {},
    .parameters = write_box_parameters,
    .items = {2, 1, 1},
};

// ----------------------------------------------------------------------------------------------------
// transfer.glift:25: fill_box<Array<1, uint, none, buffer>, uint>

struct fill_box_direct_parameters {
    uint to_extent;
    uint value;
};
static_assert(offsetof(fill_box_direct_parameters, to_extent) == 0);
static_assert(offsetof(fill_box_direct_parameters, value) == 4);

// transfer.glift:25: fill_box<Array<1, uint, none, buffer>, uint>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_direct_parameters*>(call.parameters);
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

static void fill_box_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_direct_rows(call, rows); });
}

struct fill_box_general_parameters {
    uint size;
    uint to_origin;
    uint value;
};
static_assert(offsetof(fill_box_general_parameters, size) == 0);
static_assert(offsetof(fill_box_general_parameters, to_origin) == 4);
static_assert(offsetof(fill_box_general_parameters, value) == 8);

// transfer.glift:25: fill_box<Array<1, uint, none, buffer>, uint>, some rows.
GLIFT_HOST_KERNEL
static void fill_box_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const fill_box_general_parameters*>(call.parameters);
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

static void fill_box_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { fill_box_general_rows(call, rows); });
}

const glift::Binding fill_box_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 16},
};
constexpr glift::Parameter fill_box_parameters[] = {
    {"to_extent", 0, sizeof(fill_box_direct_parameters::to_extent)},
    {"value", 4, sizeof(fill_box_direct_parameters::value)},
};
const glift::Kernel fill_box_kernel = {
    .name = "fill_box",
    .file = "transfer.glift",
    .line = 25,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = fill_box_bindings,
    .direct = {.host = &fill_box_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &fill_box_general, .parameter_bytes = 12},
    .wide = {},
    .parameters = fill_box_parameters,
    .items = {2, 1, 1},
};

void on_any(const glift::Commands& commands, const glift::Range<Line>& to) {
    glift::Iteration iteration(on_any_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (iteration.is_whole() && !commands.needs_general(on_any_kernel, memories, iteration.size())) {
        const on_any_direct_parameters parameters = {
            .to_extent = to->extent(),
        };
        commands.dispatch(on_any_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const on_any_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
        };
        commands.dispatch(on_any_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(on_any_general_parameters, size)})});
    }
}

void on_host(const glift::Commands& commands, const glift::Range<Line>& to) {
    glift::Iteration iteration(on_host_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (iteration.is_whole() && !commands.needs_general(on_host_kernel, memories, iteration.size())) {
        const on_host_direct_parameters parameters = {
            .to_extent = to->extent(),
        };
        commands.dispatch(on_host_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const on_host_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
        };
        commands.dispatch(on_host_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(on_host_general_parameters, size)})});
    }
}

void on_gpu(const glift::Commands& commands, const glift::Range<Line>& to) {
    glift::Iteration iteration(on_gpu_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (iteration.is_whole() && !commands.needs_general(on_gpu_kernel, memories, iteration.size())) {
        const on_gpu_direct_parameters parameters = {
            .to_extent = to->extent(),
        };
        commands.dispatch(on_gpu_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const on_gpu_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
        };
        commands.dispatch(on_gpu_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(on_gpu_general_parameters, size)})});
    }
}

void on_wide_subgroups(const glift::Commands& commands, const glift::Range<Line>& to) {
    glift::Iteration iteration(on_wide_subgroups_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (iteration.is_whole() && !commands.needs_general(on_wide_subgroups_kernel, memories, iteration.size())) {
        const on_wide_subgroups_direct_parameters parameters = {
            .to_extent = to->extent(),
        };
        commands.dispatch(on_wide_subgroups_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const on_wide_subgroups_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
        };
        commands.dispatch(on_wide_subgroups_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(on_wide_subgroups_general_parameters,
            size)})});
    }
}

void on_vulkan(const glift::Commands& commands, const glift::Range<Line>& to) {
    glift::Iteration iteration(on_vulkan_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (iteration.is_whole() && !commands.needs_general(on_vulkan_kernel, memories, iteration.size())) {
        const on_vulkan_direct_parameters parameters = {
            .to_extent = to->extent(),
        };
        commands.dispatch(on_vulkan_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const on_vulkan_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
        };
        commands.dispatch(on_vulkan_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(on_vulkan_general_parameters, size)})});
    }
}

void read_box(const glift::Commands& commands, const glift::Range<Line>& from, const glift::Range<Box_1_uint>& to) {
    glift::Iteration iteration(read_box_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (iteration.is_whole() && !commands.needs_general(read_box_kernel, memories, iteration.size())) {
        const read_box_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(read_box_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const read_box_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(read_box_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(read_box_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void write_box(const glift::Commands& commands, const glift::Range<Box_1_uint>& from, const glift::Range<Line>& to) {
    glift::Iteration iteration(write_box_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (iteration.is_whole() && !commands.needs_general(write_box_kernel, memories, iteration.size())) {
        const write_box_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(write_box_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const write_box_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(write_box_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(write_box_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void fill_box(const glift::Commands& commands, const glift::Range<Line>& to, uint value) {
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
            .value = value,
        };
        commands.dispatch(fill_box_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(fill_box_general_parameters, size)})});
    }
}

void by_gpu(const glift::Commands& commands, const Line& to);

Box_1_uint::Box_1_uint(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.allocate({.name = "Box_1_uint.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

Box_1_uint::Box_1_uint(const glift::Commands& commands, uint extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Box_1_uint.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

uint Box_1_uint::domain() const {
    return extent_;
}

bool Box_1_uint::same_state(const Box_1_uint& other) const {
    return extent_ == other.extent_;
}

// devices.glift:28: by_gpu
void by_gpu(const glift::Commands& commands, const Line& to) {
    // devices.glift:29
    on_gpu(commands, to);
}

}  // namespace

Line::Line(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.allocate({.name = "Line.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

Line::Line(const glift::Commands& commands, uint extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.adopt(std::move(data), {.name = "Line.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

uint Line::domain() const {
    return extent_;
}

bool Line::same_state(const Line& other) const {
    return extent_ == other.extent_;
}

std::uint64_t Line::place(uint address) const {
    [[maybe_unused]] const uint extent = extent_;
    const auto translate = [&](uint va) -> uint {
        // linear.glift:12
        return linearize(va, extent);
    };
    return translate(address);
}

void Line::copy_out(const glift::Commands& commands, const glift::Range<Line>& range, const glift::Memory& box) const {
    read_box(commands, range, Box_1_uint(commands, range.size(), box));
}

void Line::copy_in(const glift::Commands& commands, const glift::Range<Line>& range, const glift::Memory& box) const {
    write_box(commands, Box_1_uint(commands, range.size(), box), range);
}

void Line::fill(uint value, const glift::Range<Line>& range) {
    fill_box(device(), range, value);
}
void Line::fill(uint value) {
    fill(value, *this);
}

// devices.glift:32: fill
void fill(const glift::Commands& commands, const Line& to, bool many) {
    // devices.glift:33
    on_any(commands, to);
    // devices.glift:34
    if ((commands.device().properties().kind == glift::DeviceKind::gpu) && many) {
        // devices.glift:35
        by_gpu(commands, to);
    }
    // devices.glift:37
    if (commands.device().properties().subgroup_size % 8u == 0u) {
        // devices.glift:38
        on_wide_subgroups(commands, to);
    }
    // devices.glift:40
    if (commands.device().is_host()) {
        // devices.glift:41
        on_host(commands, to);
        // devices.glift:42
        return;
    }
    // devices.glift:44
    on_vulkan(commands, to);
}

}  // namespace devices
