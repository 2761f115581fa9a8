// Made by gliftc from subgroups.glift. Changes are lost when it is made again.
#include "subgroups.glift.hpp"

#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>

#include <optional>

namespace subgroups {

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

// subgroups.glift:14: better
inline Best better(Best a, Best b) {
    // subgroups.glift:15
    if (b.value < a.value) {
        // subgroups.glift:16
        return b;
    }
    // subgroups.glift:18
    return a;
}

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
// subgroups.glift:21: best_of_subgroup

struct best_of_subgroup_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(best_of_subgroup_direct_parameters, from_extent) == 0);

// subgroups.glift:21: best_of_subgroup, one workgroup.
GLIFT_HOST_KERNEL
static void best_of_subgroup_direct_group(const glift::HostCall& call, [[maybe_unused]] uint3 group_id,
    [[maybe_unused]] uint3 group_count) {
    [[maybe_unused]] constexpr uint group_size = 64;
    [[maybe_unused]] const uint group_index = (group_id.z * group_count.y + group_id.y) * group_count.x + group_id.x;
    [[maybe_unused]] const uint group_total = group_count.x * group_count.y * group_count.z;
    const auto& parameters = *static_cast<const best_of_subgroup_direct_parameters*>(call.parameters);
    const uint from_extent = parameters.from_extent;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (uint local_index = 0; local_index < 64; ++local_index) {
        const uint3 local_id{local_index % 64, local_index / 64 % 1, local_index / 64};
        const uint3 global_id = group_id * uint3(64, 1, 1) + local_id;
        // subgroups.glift:21
        const uint address_2 = global_id.y * (group_count.x * 64u) + global_id.x;
        const bool in_range = address_2 < from_extent;
        // subgroups.glift:22
        const uint lane_2 = 0u;
        // subgroups.glift:23
        uint from_value = 0u;
        if (in_range) {
            from_value = from_data[address_2];
        }
        const uint value = from_value;
        Best best = Best{float(value), uint2(lane_2, local_index), glift::array<int, 2>{{1, 2}}};
        // subgroups.glift:24
        uint stride = 1u / 2u;
        // subgroups.glift:25
        while (stride > 0u) {
            // subgroups.glift:26
            best = better(best, glift::subgroupShuffleXor(best, stride));
            // subgroups.glift:27
            stride = stride / 2u;
        }
        // subgroups.glift:29
        const uint2 first_2 = glift::subgroupBroadcast(best.where, 0u);
        // subgroups.glift:30
        const uint4 mask = glift::subgroupBallot(lane_2 == first_2.x);
        // subgroups.glift:31
        if (in_range) {
            to_data[address_2] = first_2.x + mask.x + 64u + glift::subgroupShuffle(value, lane_2 + 1u);
        }
    }
}

static void best_of_subgroup_direct(const glift::HostCall& call) {
    glift::host::for_each_group(call.size, uint3(64, 1, 1), [&](uint3 group_id, uint3 group_count) {
        best_of_subgroup_direct_group(call, group_id, group_count);
    });
}

struct best_of_subgroup_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(best_of_subgroup_general_parameters, size) == 0);
static_assert(offsetof(best_of_subgroup_general_parameters, from_origin) == 4);
static_assert(offsetof(best_of_subgroup_general_parameters, to_origin) == 8);

// subgroups.glift:21: best_of_subgroup, one workgroup.
GLIFT_HOST_KERNEL
static void best_of_subgroup_general_group(const glift::HostCall& call, [[maybe_unused]] uint3 group_id,
    [[maybe_unused]] uint3 group_count) {
    [[maybe_unused]] constexpr uint group_size = 64;
    [[maybe_unused]] const uint group_index = (group_id.z * group_count.y + group_id.y) * group_count.x + group_id.x;
    [[maybe_unused]] const uint group_total = group_count.x * group_count.y * group_count.z;
    const auto& parameters = *static_cast<const best_of_subgroup_general_parameters*>(call.parameters);
    const uint size = parameters.size;
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (uint local_index = 0; local_index < 64; ++local_index) {
        const uint3 local_id{local_index % 64, local_index / 64 % 1, local_index / 64};
        const uint3 global_id = group_id * uint3(64, 1, 1) + local_id;
        // subgroups.glift:21
        const uint address_2 = global_id.y * (group_count.x * 64u) + global_id.x;
        const bool in_range = address_2 < size;
        // subgroups.glift:23
        const uint from_address = from_origin + address_2;
        // subgroups.glift:31
        const uint to_address = to_origin + address_2;
        // subgroups.glift:22
        const uint lane_2 = 0u;
        // subgroups.glift:23
        uint from_value = 0u;
        if (in_range) {
            from_value = from_data[from_address];
        }
        const uint from_value_2 = from_value;
        Best best = Best{float(from_value_2), uint2(lane_2, local_index), glift::array<int, 2>{{1, 2}}};
        // subgroups.glift:24
        uint stride = 1u / 2u;
        // subgroups.glift:25
        while (stride > 0u) {
            // subgroups.glift:26
            best = better(best, glift::subgroupShuffleXor(best, stride));
            // subgroups.glift:27
            stride = stride / 2u;
        }
        // subgroups.glift:29
        const uint2 first_2 = glift::subgroupBroadcast(best.where, 0u);
        // subgroups.glift:30
        const uint4 mask = glift::subgroupBallot(lane_2 == first_2.x);
        // subgroups.glift:31
        if (in_range) {
            to_data[to_address] = first_2.x + mask.x + 64u + glift::subgroupShuffle(from_value_2, lane_2 + 1u);
        }
    }
}

static void best_of_subgroup_general(const glift::HostCall& call) {
    glift::host::for_each_group(call.size, uint3(64, 1, 1), [&](uint3 group_id, uint3 group_count) {
        best_of_subgroup_general_group(call, group_id, group_count);
    });
}

const glift::Binding best_of_subgroup_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter best_of_subgroup_parameters[] = {
    {"from_extent", 0, sizeof(best_of_subgroup_direct_parameters::from_extent)},
};
const glift::Kernel best_of_subgroup_kernel = {
    .name = "best_of_subgroup",
    .file = "subgroups.glift",
    .line = 21,
    .rank = 1,
    .group = {64, 1, 1},
    .loop_rounds = UINT64_MAX,
    .bindings = best_of_subgroup_bindings,
    .direct = {.host = &best_of_subgroup_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &best_of_subgroup_general, .parameter_bytes = 12},
    .wide = {},
    .parameters = best_of_subgroup_parameters,
    .reports = true,
    .longest_loop = {"subgroups.glift", 25},
};

// ----------------------------------------------------------------------------------------------------
// subgroups.glift:35: turn_subgroups

struct turn_subgroups_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(turn_subgroups_direct_parameters, from_extent) == 0);

// subgroups.glift:35: turn_subgroups, one workgroup.
GLIFT_HOST_KERNEL
static void turn_subgroups_direct_group(const glift::HostCall& call, [[maybe_unused]] uint3 group_id,
    [[maybe_unused]] uint3 group_count) {
    [[maybe_unused]] constexpr uint group_size = 64;
    [[maybe_unused]] const uint group_index = (group_id.z * group_count.y + group_id.y) * group_count.x + group_id.x;
    [[maybe_unused]] const uint group_total = group_count.x * group_count.y * group_count.z;
    const auto& parameters = *static_cast<const turn_subgroups_direct_parameters*>(call.parameters);
    const uint from_extent = parameters.from_extent;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    glift::array<uint, 64> values;
    for (uint local_index = 0; local_index < 64; ++local_index) {
        const uint3 local_id{local_index % 64, local_index / 64 % 1, local_index / 64};
        const uint3 global_id = group_id * uint3(64, 1, 1) + local_id;
        // subgroups.glift:35
        const uint address_2 = global_id.y * (group_count.x * 64u) + global_id.x;
        const bool in_range = address_2 < from_extent;
        // subgroups.glift:37
        uint from_value = 0u;
        if (in_range) {
            from_value = from_data[address_2];
        }
        values[local_index] = from_value;
        // subgroups.glift:39
        if (in_range) {
            to_data[address_2] = values[local_index + 1u - 1u - 2u * 0u];
        }
    }
}

static void turn_subgroups_direct(const glift::HostCall& call) {
    glift::host::for_each_group(call.size, uint3(64, 1, 1), [&](uint3 group_id, uint3 group_count) {
        turn_subgroups_direct_group(call, group_id, group_count);
    });
}

struct turn_subgroups_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(turn_subgroups_general_parameters, size) == 0);
static_assert(offsetof(turn_subgroups_general_parameters, from_origin) == 4);
static_assert(offsetof(turn_subgroups_general_parameters, to_origin) == 8);

// subgroups.glift:35: turn_subgroups, one workgroup.
GLIFT_HOST_KERNEL
static void turn_subgroups_general_group(const glift::HostCall& call, [[maybe_unused]] uint3 group_id,
    [[maybe_unused]] uint3 group_count) {
    [[maybe_unused]] constexpr uint group_size = 64;
    [[maybe_unused]] const uint group_index = (group_id.z * group_count.y + group_id.y) * group_count.x + group_id.x;
    [[maybe_unused]] const uint group_total = group_count.x * group_count.y * group_count.z;
    const auto& parameters = *static_cast<const turn_subgroups_general_parameters*>(call.parameters);
    const uint size = parameters.size;
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    glift::array<uint, 64> values;
    for (uint local_index = 0; local_index < 64; ++local_index) {
        const uint3 local_id{local_index % 64, local_index / 64 % 1, local_index / 64};
        const uint3 global_id = group_id * uint3(64, 1, 1) + local_id;
        // subgroups.glift:35
        const uint address_2 = global_id.y * (group_count.x * 64u) + global_id.x;
        const bool in_range = address_2 < size;
        // subgroups.glift:37
        const uint from_address = from_origin + address_2;
        // subgroups.glift:39
        const uint to_address = to_origin + address_2;
        // subgroups.glift:37
        uint from_value = 0u;
        if (in_range) {
            from_value = from_data[from_address];
        }
        const uint from_value_2 = from_value;
        values[local_index] = from_value_2;
        // subgroups.glift:39
        if (in_range) {
            to_data[to_address] = values[local_index + 1u - 1u - 2u * 0u];
        }
    }
}

static void turn_subgroups_general(const glift::HostCall& call) {
    glift::host::for_each_group(call.size, uint3(64, 1, 1), [&](uint3 group_id, uint3 group_count) {
        turn_subgroups_general_group(call, group_id, group_count);
    });
}

const glift::Binding turn_subgroups_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter turn_subgroups_parameters[] = {
    {"from_extent", 0, sizeof(turn_subgroups_direct_parameters::from_extent)},
};
const glift::Kernel turn_subgroups_kernel = {
    .name = "turn_subgroups",
    .file = "subgroups.glift",
    .line = 35,
    .rank = 1,
    .group = {64, 1, 1},
    .loop_rounds = 0,
    .bindings = turn_subgroups_bindings,
    .direct = {.host = &turn_subgroups_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &turn_subgroups_general, .parameter_bytes = 12},
    .wide = {},
    .parameters = turn_subgroups_parameters,
    .shared_bytes = 256,
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

void best_of_subgroup(const glift::Commands& commands, const glift::Range<Values>& from,
    const glift::Range<Values>& to) {
    glift::Iteration iteration(best_of_subgroup_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (iteration.is_whole() && from->same_state(to.structure()) && iteration.sharing() != glift::Sharing::one_place
        && !commands.needs_general(best_of_subgroup_kernel, memories, iteration.size())) {
        const best_of_subgroup_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(best_of_subgroup_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const best_of_subgroup_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(best_of_subgroup_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(best_of_subgroup_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

void turn_subgroups(const glift::Commands& commands, const glift::Range<Values>& from, const glift::Range<Values>& to) {
    glift::Iteration iteration(turn_subgroups_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (iteration.is_whole() && from->same_state(to.structure()) && iteration.sharing() != glift::Sharing::one_place
        && !commands.needs_general(turn_subgroups_kernel, memories, iteration.size())) {
        const turn_subgroups_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(turn_subgroups_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const turn_subgroups_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(turn_subgroups_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(turn_subgroups_general_parameters, size)}),
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

}  // namespace subgroups
