// Made by gliftc from predicates.glift. Changes are lost when it is made again.
#include "predicates.glift.hpp"

#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>

#include <optional>

namespace predicates {

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
// predicates.glift:10: shift

struct shift_direct_parameters {
    uint x_extent;
    uint by;
};
static_assert(offsetof(shift_direct_parameters, x_extent) == 0);
static_assert(offsetof(shift_direct_parameters, by) == 4);

// predicates.glift:10: shift, one workgroup.
GLIFT_HOST_KERNEL
static void shift_direct_group(const glift::HostCall& call, [[maybe_unused]] uint3 group_id,
    [[maybe_unused]] uint3 group_count) {
    [[maybe_unused]] constexpr uint group_size = 64;
    [[maybe_unused]] const uint group_index = (group_id.z * group_count.y + group_id.y) * group_count.x + group_id.x;
    [[maybe_unused]] const uint group_total = group_count.x * group_count.y * group_count.z;
    const auto& parameters = *static_cast<const shift_direct_parameters*>(call.parameters);
    const uint x_extent = parameters.x_extent;
    const uint by = parameters.by;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    const uint* x_data = glift::host::elements<const uint>(call.memories[1]);
    uint* to_data = glift::host::elements<uint>(call.memories[2]);
    glift::array<uint, 64> part_2;
    uint address_2[64];
    bool in_range[64];
    uint next[64];
    uint chosen[64];
    bool test[64];
    for (uint local_index = 0; local_index < 64; ++local_index) {
        const uint3 local_id{local_index % 64, local_index / 64 % 1, local_index / 64};
        const uint3 global_id = group_id * uint3(64, 1, 1) + local_id;
        // predicates.glift:10
        address_2[local_index] = global_id.y * (group_count.x * 64u) + global_id.x;
        in_range[local_index] = address_2[local_index] < x_extent;
        // predicates.glift:12
        const uint i_2 = address_2[local_index] + by;
        // predicates.glift:13
        const bool from_value_inside = i_2 < x_extent;
        uint from_value = 0u;
        if (from_value_inside) {
            from_value = from_data[i_2];
        }
        next[local_index] = from_value;
        // predicates.glift:14
        test[local_index] = i_2 % 2u == 0u;
        const uint from_address = test[local_index] ? i_2 : by;
        const bool from_value_inside_2 = from_address < x_extent;
        uint from_value_2 = 0u;
        if (from_value_inside_2) {
            from_value_2 = from_data[from_address];
        }
        chosen[local_index] = from_value_2;
        // predicates.glift:15
        uint x_value = 0u;
        if (in_range[local_index]) {
            x_value = x_data[address_2[local_index]];
        }
        part_2[local_index] = x_value + next[local_index];
    }
    // predicates.glift:16
    // barrier
    for (uint local_index = 0; local_index < 64; ++local_index) {
        // predicates.glift:17
        const uint x_value = x_data[in_range[local_index] ? address_2[local_index] : 0u];
        if (in_range[local_index]) {
            to_data[address_2[local_index]] = part_2[63u - local_index] + chosen[local_index]
                + (test[local_index] ? chosen[local_index] : 7u) + next[local_index] + x_value;
        }
    }
}

static void shift_direct(const glift::HostCall& call) {
    glift::host::for_each_group(call.size, uint3(64, 1, 1), [&](uint3 group_id, uint3 group_count) {
        shift_direct_group(call, group_id, group_count);
    });
}

struct shift_general_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint x_origin;
    uint to_origin;
    uint by;
};
static_assert(offsetof(shift_general_parameters, size) == 0);
static_assert(offsetof(shift_general_parameters, from_origin) == 4);
static_assert(offsetof(shift_general_parameters, from_size) == 8);
static_assert(offsetof(shift_general_parameters, x_origin) == 12);
static_assert(offsetof(shift_general_parameters, to_origin) == 16);
static_assert(offsetof(shift_general_parameters, by) == 20);

// predicates.glift:10: shift, one workgroup.
GLIFT_HOST_KERNEL
static void shift_general_group(const glift::HostCall& call, [[maybe_unused]] uint3 group_id,
    [[maybe_unused]] uint3 group_count) {
    [[maybe_unused]] constexpr uint group_size = 64;
    [[maybe_unused]] const uint group_index = (group_id.z * group_count.y + group_id.y) * group_count.x + group_id.x;
    [[maybe_unused]] const uint group_total = group_count.x * group_count.y * group_count.z;
    const auto& parameters = *static_cast<const shift_general_parameters*>(call.parameters);
    const uint size = parameters.size;
    const uint from_origin = parameters.from_origin;
    const uint from_size = parameters.from_size;
    const uint x_origin = parameters.x_origin;
    const uint to_origin = parameters.to_origin;
    const uint by = parameters.by;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    const uint* x_data = glift::host::elements<const uint>(call.memories[1]);
    uint* to_data = glift::host::elements<uint>(call.memories[2]);
    glift::array<uint, 64> part_2;
    bool in_range[64];
    uint next[64];
    uint chosen[64];
    uint x_address[64];
    uint to_address[64];
    bool test[64];
    for (uint local_index = 0; local_index < 64; ++local_index) {
        const uint3 local_id{local_index % 64, local_index / 64 % 1, local_index / 64};
        const uint3 global_id = group_id * uint3(64, 1, 1) + local_id;
        // predicates.glift:10
        const uint address_2 = global_id.y * (group_count.x * 64u) + global_id.x;
        in_range[local_index] = address_2 < size;
        // predicates.glift:15
        x_address[local_index] = x_origin + address_2;
        // predicates.glift:17
        to_address[local_index] = to_origin + address_2;
        // predicates.glift:12
        const uint i_2 = address_2 + by;
        // predicates.glift:13
        const uint from_virtual = from_origin + i_2;
        const bool from_value_inside = i_2 < from_size;
        uint from_value = 0u;
        if (from_value_inside) {
            from_value = from_data[from_virtual];
        }
        next[local_index] = from_value;
        // predicates.glift:14
        test[local_index] = i_2 % 2u == 0u;
        const uint from_address = test[local_index] ? i_2 : by;
        const uint from_virtual_2 = from_origin + from_address;
        const bool from_value_inside_2 = from_address < from_size;
        uint from_value_2 = 0u;
        if (from_value_inside_2) {
            from_value_2 = from_data[from_virtual_2];
        }
        chosen[local_index] = from_value_2;
        // predicates.glift:15
        uint x_value = 0u;
        if (in_range[local_index]) {
            x_value = x_data[x_address[local_index]];
        }
        const uint x_value_2 = x_value;
        part_2[local_index] = x_value_2 + next[local_index];
    }
    // predicates.glift:16
    // barrier
    for (uint local_index = 0; local_index < 64; ++local_index) {
        // predicates.glift:17
        uint x_value = 0u;
        if (in_range[local_index]) {
            x_value = x_data[x_address[local_index]];
        }
        const uint x_value_2 = x_value;
        if (in_range[local_index]) {
            to_data[to_address[local_index]] = part_2[63u - local_index] + chosen[local_index]
                + (test[local_index] ? chosen[local_index] : 7u) + next[local_index] + x_value_2;
        }
    }
}

static void shift_general(const glift::HostCall& call) {
    glift::host::for_each_group(call.size, uint3(64, 1, 1), [&](uint3 group_id, uint3 group_count) {
        shift_general_group(call, group_id, group_count);
    });
}

const glift::Binding shift_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24,
        .parameter = 1, .reach = glift::Reach::range},
    {.name = "x.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 32,
        .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 40,
        .parameter = 2, .reach = glift::Reach::element},
};
constexpr glift::Parameter shift_parameters[] = {
    {"x_extent", 0, sizeof(shift_direct_parameters::x_extent)},
    {"by", 4, sizeof(shift_direct_parameters::by)},
};
const glift::Kernel shift_kernel = {
    .name = "shift",
    .file = "predicates.glift",
    .line = 10,
    .rank = 1,
    .group = {64, 1, 1},
    .loop_rounds = 0,
    .bindings = shift_bindings,
    .direct = {.host = &shift_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &shift_general, .parameter_bytes = 24},
    .wide = {},
    .parameters = shift_parameters,
    .shared_bytes = 256,
};

// ----------------------------------------------------------------------------------------------------
// predicates.glift:21: pick

struct pick_direct_parameters {
    uint x_extent;
};
static_assert(offsetof(pick_direct_parameters, x_extent) == 0);

// predicates.glift:21: pick, one workgroup.
GLIFT_HOST_KERNEL
static void pick_direct_group(const glift::HostCall& call, [[maybe_unused]] uint3 group_id,
    [[maybe_unused]] uint3 group_count) {
    [[maybe_unused]] constexpr uint group_size = 64;
    [[maybe_unused]] const uint group_index = (group_id.z * group_count.y + group_id.y) * group_count.x + group_id.x;
    [[maybe_unused]] const uint group_total = group_count.x * group_count.y * group_count.z;
    const auto& parameters = *static_cast<const pick_direct_parameters*>(call.parameters);
    const uint x_extent = parameters.x_extent;
    const uint* x_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    uint address_2[64];
    bool in_range[64];
    uint first_2[64];
    uint second[64];
    for (uint local_index = 0; local_index < 64; ++local_index) {
        const uint3 local_id{local_index % 64, local_index / 64 % 1, local_index / 64};
        const uint3 global_id = group_id * uint3(64, 1, 1) + local_id;
        // predicates.glift:21
        address_2[local_index] = global_id.y * (group_count.x * 64u) + global_id.x;
        in_range[local_index] = address_2[local_index] < x_extent;
        // predicates.glift:22
        const bool inside_2 = local_index < 32u;
        // predicates.glift:23
        uint result{};
        if (inside_2) {
            uint x_value = 0u;
            if (in_range[local_index]) {
                x_value = x_data[address_2[local_index]];
            }
            result = x_value;
        } else {
            result = 3u;
        }
        first_2[local_index] = result;
        // predicates.glift:24
        uint result_2{};
        if (inside_2) {
            uint x_value = 0u;
            if (in_range[local_index]) {
                x_value = x_data[address_2[local_index]];
            }
            result_2 = x_value;
        } else {
            result_2 = 4u;
        }
        second[local_index] = result_2;
    }
    // predicates.glift:25
    // barrier
    for (uint local_index = 0; local_index < 64; ++local_index) {
        // predicates.glift:26
        if (in_range[local_index]) {
            to_data[address_2[local_index]] = first_2[local_index] + second[local_index];
        }
    }
}

static void pick_direct(const glift::HostCall& call) {
    glift::host::for_each_group(call.size, uint3(64, 1, 1), [&](uint3 group_id, uint3 group_count) {
        pick_direct_group(call, group_id, group_count);
    });
}

struct pick_general_parameters {
    uint size;
    uint x_origin;
    uint to_origin;
};
static_assert(offsetof(pick_general_parameters, size) == 0);
static_assert(offsetof(pick_general_parameters, x_origin) == 4);
static_assert(offsetof(pick_general_parameters, to_origin) == 8);

// predicates.glift:21: pick, one workgroup.
GLIFT_HOST_KERNEL
static void pick_general_group(const glift::HostCall& call, [[maybe_unused]] uint3 group_id,
    [[maybe_unused]] uint3 group_count) {
    [[maybe_unused]] constexpr uint group_size = 64;
    [[maybe_unused]] const uint group_index = (group_id.z * group_count.y + group_id.y) * group_count.x + group_id.x;
    [[maybe_unused]] const uint group_total = group_count.x * group_count.y * group_count.z;
    const auto& parameters = *static_cast<const pick_general_parameters*>(call.parameters);
    const uint size = parameters.size;
    const uint x_origin = parameters.x_origin;
    const uint to_origin = parameters.to_origin;
    const uint* x_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    bool in_range[64];
    uint first_2[64];
    uint second[64];
    uint to_address[64];
    for (uint local_index = 0; local_index < 64; ++local_index) {
        const uint3 local_id{local_index % 64, local_index / 64 % 1, local_index / 64};
        const uint3 global_id = group_id * uint3(64, 1, 1) + local_id;
        // predicates.glift:21
        const uint address_2 = global_id.y * (group_count.x * 64u) + global_id.x;
        in_range[local_index] = address_2 < size;
        // predicates.glift:23
        const uint x_address = x_origin + address_2;
        // predicates.glift:26
        to_address[local_index] = to_origin + address_2;
        // predicates.glift:22
        const bool inside_2 = local_index < 32u;
        // predicates.glift:23
        uint result{};
        if (inside_2) {
            uint x_value = 0u;
            if (in_range[local_index]) {
                x_value = x_data[x_address];
            }
            const uint x_value_2 = x_value;
            result = x_value_2;
        } else {
            result = 3u;
        }
        first_2[local_index] = result;
        // predicates.glift:24
        uint result_2{};
        if (inside_2) {
            uint x_value = 0u;
            if (in_range[local_index]) {
                x_value = x_data[x_address];
            }
            const uint x_value_2 = x_value;
            result_2 = x_value_2;
        } else {
            result_2 = 4u;
        }
        second[local_index] = result_2;
    }
    // predicates.glift:25
    // barrier
    for (uint local_index = 0; local_index < 64; ++local_index) {
        // predicates.glift:26
        if (in_range[local_index]) {
            to_data[to_address[local_index]] = first_2[local_index] + second[local_index];
        }
    }
}

static void pick_general(const glift::HostCall& call) {
    glift::host::for_each_group(call.size, uint3(64, 1, 1), [&](uint3 group_id, uint3 group_count) {
        pick_general_group(call, group_id, group_count);
    });
}

const glift::Binding pick_bindings[] = {
    {.name = "x.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter pick_parameters[] = {
    {"x_extent", 0, sizeof(pick_direct_parameters::x_extent)},
};
const glift::Kernel pick_kernel = {
    .name = "pick",
    .file = "predicates.glift",
    .line = 21,
    .rank = 1,
    .group = {64, 1, 1},
    .loop_rounds = 0,
    .bindings = pick_bindings,
    .direct = {.host = &pick_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &pick_general, .parameter_bytes = 12},
    .wide = {},
    .parameters = pick_parameters,
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

void shift(const glift::Commands& commands, const glift::Range<Line>& x, const glift::Range<Line>& from, uint by,
    const glift::Range<Line>& to) {
    glift::Iteration iteration(shift_kernel);
    iteration.each("x", x);
    iteration.each("to", to);
    iteration.any("from", from);
    const glift::Memory memories[] = {from->data(), x->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {x, from, to});
    if (iteration.is_whole() && x->same_state(from.structure()) && from->same_state(to.structure())
        && iteration.sharing() != glift::Sharing::one_place
        && !commands.needs_general(shift_kernel, memories, iteration.size())) {
        const shift_direct_parameters parameters = {
            .x_extent = x->extent(),
            .by = by,
        };
        commands.dispatch(shift_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const shift_general_parameters parameters = {
            .size = x.size(),
            .from_origin = from.origin(),
            .from_size = from.size(),
            .x_origin = x.origin(),
            .to_origin = to.origin(),
            .by = by,
        };
        iteration.count(from, offsetof(shift_general_parameters, from_size));
        commands.dispatch(shift_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(shift_general_parameters, size)}), .sharing = iteration.sharing()});
    }
}

void pick(const glift::Commands& commands, const glift::Range<Line>& x, const glift::Range<Line>& to) {
    glift::Iteration iteration(pick_kernel);
    iteration.each("x", x);
    iteration.each("to", to);
    const glift::Memory memories[] = {x->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {x, to});
    if (iteration.is_whole() && x->same_state(to.structure()) && iteration.sharing() != glift::Sharing::one_place
        && !commands.needs_general(pick_kernel, memories, iteration.size())) {
        const pick_direct_parameters parameters = {
            .x_extent = x->extent(),
        };
        commands.dispatch(pick_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const pick_general_parameters parameters = {
            .size = x.size(),
            .x_origin = x.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(pick_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(pick_general_parameters, size)}), .sharing = iteration.sharing()});
    }
}

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

}  // namespace predicates
