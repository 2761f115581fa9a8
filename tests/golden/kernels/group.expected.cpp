// Made by gliftc from group.glift. Changes are lost when it is made again.
#include "group.glift.hpp"

#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>

#include <optional>

namespace group_ {

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
// group.glift:8: block_sums

struct block_sums_direct_parameters {
    uint value_extent;
};
static_assert(offsetof(block_sums_direct_parameters, value_extent) == 0);

// group.glift:8: block_sums, one workgroup.
GLIFT_HOST_KERNEL
static void block_sums_direct_group(const glift::HostCall& call, [[maybe_unused]] uint3 group_id,
    [[maybe_unused]] uint3 group_count) {
    [[maybe_unused]] constexpr uint group_size = 64;
    [[maybe_unused]] const uint group_index = (group_id.z * group_count.y + group_id.y) * group_count.x + group_id.x;
    [[maybe_unused]] const uint group_total = group_count.x * group_count.y * group_count.z;
    const auto& parameters = *static_cast<const block_sums_direct_parameters*>(call.parameters);
    const uint value_extent = parameters.value_extent;
    const uint* value_data = glift::host::elements<const uint>(call.memories[0]);
    uint* sums_data = glift::host::elements<uint>(call.memories[1]);
    glift::array<uint, 64> part_2;
    uint i_2[64];
    uint step[64];
    for (uint local_index = 0; local_index < 64; ++local_index) {
        const uint3 local_id{local_index % 64, local_index / 64 % 1, local_index / 64};
        const uint3 global_id = group_id * uint3(64, 1, 1) + local_id;
        // group.glift:8
        const uint address_2 = global_id.y * (group_count.x * 64u) + global_id.x;
        const bool in_range = address_2 < value_extent;
        // group.glift:10
        i_2[local_index] = local_index;
        // group.glift:11
        uint value_value = 0u;
        if (in_range) {
            value_value = value_data[address_2];
        }
        part_2[i_2[local_index]] = value_value;
    }
    // group.glift:12
    // barrier
    for (uint local_index = 0; local_index < 64; ++local_index) {
        // group.glift:13
        step[local_index] = 32u;
    }
    // group.glift:14
    while (step[0] > 0u) {
        for (uint local_index = 0; local_index < 64; ++local_index) {
            // group.glift:15
            if (i_2[local_index] < step[local_index]) {
                part_2[i_2[local_index]] += part_2[i_2[local_index] + step[local_index]];
            }
        }
        // group.glift:16
        // barrier
        for (uint local_index = 0; local_index < 64; ++local_index) {
            // group.glift:17
            step[local_index] = step[local_index] / 2u;
        }
    }
    for (uint local_index = 0; local_index < 64; ++local_index) {
        // group.glift:19
        if (i_2[local_index] == 0u) {
            const uint sums_address = group_id.y * group_count.x + group_id.x;
            if (sums_address < value_extent) {
                sums_data[sums_address] = part_2[0u];
            }
        }
    }
}

static void block_sums_direct(const glift::HostCall& call) {
    glift::host::for_each_group(call.size, uint3(64, 1, 1), [&](uint3 group_id, uint3 group_count) {
        block_sums_direct_group(call, group_id, group_count);
    });
}

struct block_sums_general_parameters {
    uint size;
    uint value_origin;
    uint sums_origin;
    uint sums_size;
};
static_assert(offsetof(block_sums_general_parameters, size) == 0);
static_assert(offsetof(block_sums_general_parameters, value_origin) == 4);
static_assert(offsetof(block_sums_general_parameters, sums_origin) == 8);
static_assert(offsetof(block_sums_general_parameters, sums_size) == 12);

// group.glift:8: block_sums, one workgroup.
GLIFT_HOST_KERNEL
static void block_sums_general_group(const glift::HostCall& call, [[maybe_unused]] uint3 group_id,
    [[maybe_unused]] uint3 group_count) {
    [[maybe_unused]] constexpr uint group_size = 64;
    [[maybe_unused]] const uint group_index = (group_id.z * group_count.y + group_id.y) * group_count.x + group_id.x;
    [[maybe_unused]] const uint group_total = group_count.x * group_count.y * group_count.z;
    const auto& parameters = *static_cast<const block_sums_general_parameters*>(call.parameters);
    const uint size = parameters.size;
    const uint value_origin = parameters.value_origin;
    const uint sums_origin = parameters.sums_origin;
    const uint sums_size = parameters.sums_size;
    const uint* value_data = glift::host::elements<const uint>(call.memories[0]);
    uint* sums_data = glift::host::elements<uint>(call.memories[1]);
    glift::array<uint, 64> part_2;
    uint i_2[64];
    uint step[64];
    for (uint local_index = 0; local_index < 64; ++local_index) {
        const uint3 local_id{local_index % 64, local_index / 64 % 1, local_index / 64};
        const uint3 global_id = group_id * uint3(64, 1, 1) + local_id;
        // group.glift:8
        const uint address_2 = global_id.y * (group_count.x * 64u) + global_id.x;
        const bool in_range = address_2 < size;
        // group.glift:11
        const uint value_address = value_origin + address_2;
        // group.glift:10
        i_2[local_index] = local_index;
        // group.glift:11
        uint value_value = 0u;
        if (in_range) {
            value_value = value_data[value_address];
        }
        part_2[i_2[local_index]] = value_value;
    }
    // group.glift:12
    // barrier
    for (uint local_index = 0; local_index < 64; ++local_index) {
        // group.glift:13
        step[local_index] = 32u;
    }
    // group.glift:14
    while (step[0] > 0u) {
        for (uint local_index = 0; local_index < 64; ++local_index) {
            // group.glift:15
            if (i_2[local_index] < step[local_index]) {
                part_2[i_2[local_index]] += part_2[i_2[local_index] + step[local_index]];
            }
        }
        // group.glift:16
        // barrier
        for (uint local_index = 0; local_index < 64; ++local_index) {
            // group.glift:17
            step[local_index] = step[local_index] / 2u;
        }
    }
    for (uint local_index = 0; local_index < 64; ++local_index) {
        // group.glift:19
        if (i_2[local_index] == 0u) {
            const uint sums_address = group_id.y * group_count.x + group_id.x;
            const uint sums_virtual = sums_address + sums_origin;
            if (sums_address < sums_size) {
                sums_data[sums_virtual] = part_2[0u];
            }
        }
    }
}

static void block_sums_general(const glift::HostCall& call) {
    glift::host::for_each_group(call.size, uint3(64, 1, 1), [&](uint3 group_id, uint3 group_count) {
        block_sums_general_group(call, group_id, group_count);
    });
}

const glift::Binding block_sums_bindings[] = {
    {.name = "value.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .reach = glift::Reach::element},
    {.name = "sums.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .parameter = 1, .reach = glift::Reach::range},
};
constexpr glift::Parameter block_sums_parameters[] = {
    {"value_extent", 0, sizeof(block_sums_direct_parameters::value_extent)},
};
const glift::Kernel block_sums_kernel = {
    .name = "block_sums",
    .file = "group.glift",
    .line = 8,
    .rank = 1,
    .group = {64, 1, 1},
    .loop_rounds = UINT64_MAX,
    .bindings = block_sums_bindings,
    .direct = {.host = &block_sums_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &block_sums_general, .parameter_bytes = 16},
    .wide = {},
    .parameters = block_sums_parameters,
    .reports = true,
    .shared_bytes = 256,
    .longest_loop = {"group.glift", 14},
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

void read_box(const glift::Commands& commands, const glift::Range<Values>& from, const glift::Range<Box_1_uint>& to) {
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

void write_box(const glift::Commands& commands, const glift::Range<Box_1_uint>& from, const glift::Range<Values>& to) {
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

void fill_box(const glift::Commands& commands, const glift::Range<Values>& to, uint value) {
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

}  // namespace

void block_sums(const glift::Commands& commands, const glift::Range<Values>& value, const glift::Range<Values>& sums) {
    glift::Iteration iteration(block_sums_kernel);
    iteration.each("value", value);
    iteration.any("sums", sums);
    const glift::Memory memories[] = {value->data(), sums->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {value, sums});
    if (iteration.is_whole() && value->same_state(sums.structure())
        && !commands.needs_general(block_sums_kernel, memories, iteration.size())) {
        const block_sums_direct_parameters parameters = {
            .value_extent = value->extent(),
        };
        commands.dispatch(block_sums_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const block_sums_general_parameters parameters = {
            .size = value.size(),
            .value_origin = value.origin(),
            .sums_origin = sums.origin(),
            .sums_size = sums.size(),
        };
        iteration.count(sums, offsetof(block_sums_general_parameters, sums_size));
        commands.dispatch(block_sums_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(block_sums_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

Values::Values(const glift::Commands& commands, uint extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.allocate({.name = "Values.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

Values::Values(const glift::Commands& commands, uint extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(volume(extent_)),
      data_(commands.adopt(std::move(data),
        {.name = "Values.data", .bytes = glift::buffer_bytes<uint>(data_extent_)})) {}

uint Values::domain() const {
    return extent_;
}

bool Values::same_state(const Values& other) const {
    return extent_ == other.extent_;
}

std::uint64_t Values::place(uint address) const {
    [[maybe_unused]] const uint extent = extent_;
    const auto translate = [&](uint va) -> uint {
        // linear.glift:12
        return linearize(va, extent);
    };
    return translate(address);
}

void Values::copy_out(const glift::Commands& commands, const glift::Range<Values>& range,
    const glift::Memory& box) const {
    read_box(commands, range, Box_1_uint(commands, range.size(), box));
}

void Values::copy_in(const glift::Commands& commands, const glift::Range<Values>& range,
    const glift::Memory& box) const {
    write_box(commands, Box_1_uint(commands, range.size(), box), range);
}

void Values::fill(uint value, const glift::Range<Values>& range) {
    fill_box(device(), range, value);
}
void Values::fill(uint value) {
    fill(value, *this);
}

}  // namespace group_
