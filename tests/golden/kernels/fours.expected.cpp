// Made by gliftc from fours.glift. Changes are lost when it is made again.
#include "fours.glift.hpp"

#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>

#include <optional>

namespace fours {

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
// fours.glift:8: sum_fours

struct sum_fours_direct_parameters {
    uint a_extent;
    uint shift;
};
static_assert(offsetof(sum_fours_direct_parameters, a_extent) == 0);
static_assert(offsetof(sum_fours_direct_parameters, shift) == 4);

// fours.glift:8: sum_fours, some rows.
GLIFT_HOST_KERNEL
static void sum_fours_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const sum_fours_direct_parameters*>(call.parameters);
    const uint a_extent = parameters.a_extent;
    const uint shift = parameters.shift;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x * 4;
            // fours.glift:9
            glift::array<uint, 4> from_items = glift::array<uint, 4>{};
            const uint from_vector = address / 4u;
            const uint4 from_four = glift::host::load_row(from_data, from_vector);
            from_items[0u] = from_four.x;
            const uint to_address = address + 1u;
            const bool test = to_address < a_extent;
            from_items[1u] = test ? from_four.y : 0u;
            const uint to_address_2 = address + 2u;
            const bool test_2 = to_address_2 < a_extent;
            from_items[2u] = test_2 ? from_four.z : 0u;
            const uint to_address_3 = address + 3u;
            const bool test_3 = to_address_3 < a_extent;
            from_items[3u] = test_3 ? from_four.w : 0u;
            const glift::array<uint, 4>& whole = from_items;
            // fours.glift:10
            const uint from_first = address + shift;
            glift::array<uint, 4> from_items_2 = glift::array<uint, 4>{};
            const bool from0_value_inside = from_first < a_extent;
            if (from0_value_inside && a_extent - from_first >= 4u && from_first % 4u == 0u) {
                const uint from_vector_2 = from_first / 4u;
                const uint4 from_four_2 = glift::host::load_row(from_data, from_vector_2);
                from_items_2[0u] = from_four_2.x;
                from_items_2[1u] = from_four_2.y;
                from_items_2[2u] = from_four_2.z;
                from_items_2[3u] = from_four_2.w;
            } else {
                const uint from0_value = from_data[from0_value_inside ? from_first : 0u];
                from_items_2[0u] = from0_value_inside ? from0_value : 0u;
                const uint from1_address = from_first + 1u;
                const bool from1_value_inside = from1_address < a_extent;
                const uint from1_value = from_data[from1_value_inside ? from1_address : 0u];
                from_items_2[1u] = from1_value_inside ? from1_value : 0u;
                const uint from2_address = from_first + 2u;
                const bool from2_value_inside = from2_address < a_extent;
                const uint from2_value = from_data[from2_value_inside ? from2_address : 0u];
                from_items_2[2u] = from2_value_inside ? from2_value : 0u;
                const uint from3_address = from_first + 3u;
                const bool from3_value_inside = from3_address < a_extent;
                const uint from3_value = from_data[from3_value_inside ? from3_address : 0u];
                from_items_2[3u] = from3_value_inside ? from3_value : 0u;
            }
            const glift::array<uint, 4>& other = from_items_2;
            // fours.glift:11
            glift::array<uint, 4> sums{};
            // fours.glift:12
            for (uint k = 0u; k < 4u; ++k) {
                // fours.glift:13
                sums[k] = whole[k] + other[k];
            }
            // fours.glift:15
            const glift::array<uint, 4>& to_items = sums;
            if (a_extent - address >= 4u && address % 4u == 0u) {
                glift::host::store_row(to_data, from_vector,
                    uint4(to_items[0u], to_items[1u], to_items[2u], to_items[3u]));
            } else {
                to_data[address] = to_items[0u];
                if (test) {
                    to_data[to_address] = to_items[1u];
                }
                if (test_2) {
                    to_data[to_address_2] = to_items[2u];
                }
                if (test_3) {
                    to_data[to_address_3] = to_items[3u];
                }
            }
        }
    }
}

static void sum_fours_direct(const glift::HostCall& call) {
    glift::host::for_strides(call.size[0], 4,
        [&](const glift::host::Rows& rows) { sum_fours_direct_rows(call, rows); });
}

struct sum_fours_general_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint to_origin;
    uint to_size;
    uint shift;
};
static_assert(offsetof(sum_fours_general_parameters, size) == 0);
static_assert(offsetof(sum_fours_general_parameters, from_origin) == 4);
static_assert(offsetof(sum_fours_general_parameters, from_size) == 8);
static_assert(offsetof(sum_fours_general_parameters, to_origin) == 12);
static_assert(offsetof(sum_fours_general_parameters, to_size) == 16);
static_assert(offsetof(sum_fours_general_parameters, shift) == 20);

// fours.glift:8: sum_fours, some rows.
GLIFT_HOST_KERNEL
static void sum_fours_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const sum_fours_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint from_size = parameters.from_size;
    const uint to_origin = parameters.to_origin;
    const uint to_size = parameters.to_size;
    const uint shift = parameters.shift;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x * 4;
            // fours.glift:9
            const uint from_virtual = from_origin + address;
            glift::array<uint, 4> from_items = glift::array<uint, 4>{};
            const bool from0_value_inside = address < from_size;
            if (from0_value_inside && from_size - address >= 4u && from_virtual % 4u == 0u) {
                const uint from_vector = from_virtual / 4u;
                const uint4 from_four = glift::host::load_row(from_data, from_vector);
                from_items[0u] = from_four.x;
                from_items[1u] = from_four.y;
                from_items[2u] = from_four.z;
                from_items[3u] = from_four.w;
            } else {
                const uint from0_value = from_data[from0_value_inside ? from_virtual : 0u];
                from_items[0u] = from0_value_inside ? from0_value : 0u;
                const uint from1_address = address + 1u;
                const uint from1_virtual = from_origin + from1_address;
                const bool from1_value_inside = from1_address < from_size;
                const uint from1_value = from_data[from1_value_inside ? from1_virtual : 0u];
                from_items[1u] = from1_value_inside ? from1_value : 0u;
                const uint from2_address = address + 2u;
                const uint from2_virtual = from_origin + from2_address;
                const bool from2_value_inside = from2_address < from_size;
                const uint from2_value = from_data[from2_value_inside ? from2_virtual : 0u];
                from_items[2u] = from2_value_inside ? from2_value : 0u;
                const uint from3_address = address + 3u;
                const uint from3_virtual = from_origin + from3_address;
                const bool from3_value_inside = from3_address < from_size;
                const uint from3_value = from_data[from3_value_inside ? from3_virtual : 0u];
                from_items[3u] = from3_value_inside ? from3_value : 0u;
            }
            const glift::array<uint, 4>& whole = from_items;
            // fours.glift:10
            const uint from_first = address + shift;
            const uint from_virtual_2 = from_origin + from_first;
            glift::array<uint, 4> from_items_2 = glift::array<uint, 4>{};
            const bool from0_value_inside_2 = from_first < from_size;
            if (from0_value_inside_2 && from_size - from_first >= 4u && from_virtual_2 % 4u == 0u) {
                const uint from_vector = from_virtual_2 / 4u;
                const uint4 from_four = glift::host::load_row(from_data, from_vector);
                from_items_2[0u] = from_four.x;
                from_items_2[1u] = from_four.y;
                from_items_2[2u] = from_four.z;
                from_items_2[3u] = from_four.w;
            } else {
                const uint from0_value = from_data[from0_value_inside_2 ? from_virtual_2 : 0u];
                from_items_2[0u] = from0_value_inside_2 ? from0_value : 0u;
                const uint from1_address = from_first + 1u;
                const uint from1_virtual = from_origin + from1_address;
                const bool from1_value_inside = from1_address < from_size;
                const uint from1_value = from_data[from1_value_inside ? from1_virtual : 0u];
                from_items_2[1u] = from1_value_inside ? from1_value : 0u;
                const uint from2_address = from_first + 2u;
                const uint from2_virtual = from_origin + from2_address;
                const bool from2_value_inside = from2_address < from_size;
                const uint from2_value = from_data[from2_value_inside ? from2_virtual : 0u];
                from_items_2[2u] = from2_value_inside ? from2_value : 0u;
                const uint from3_address = from_first + 3u;
                const uint from3_virtual = from_origin + from3_address;
                const bool from3_value_inside = from3_address < from_size;
                const uint from3_value = from_data[from3_value_inside ? from3_virtual : 0u];
                from_items_2[3u] = from3_value_inside ? from3_value : 0u;
            }
            const glift::array<uint, 4>& other = from_items_2;
            // fours.glift:11
            glift::array<uint, 4> sums{};
            // fours.glift:12
            for (uint k = 0u; k < 4u; ++k) {
                // fours.glift:13
                sums[k] = whole[k] + other[k];
            }
            // fours.glift:15
            const uint to_virtual = to_origin + address;
            const glift::array<uint, 4>& to_items = sums;
            const bool test = address < to_size;
            if (test && to_size - address >= 4u && to_virtual % 4u == 0u) {
                const uint to_vector = to_virtual / 4u;
                glift::host::store_row(to_data, to_vector,
                    uint4(to_items[0u], to_items[1u], to_items[2u], to_items[3u]));
            } else {
                if (test) {
                    to_data[to_virtual] = to_items[0u];
                }
                const uint to_address = address + 1u;
                const uint to_virtual_2 = to_origin + to_address;
                if (to_address < to_size) {
                    to_data[to_virtual_2] = to_items[1u];
                }
                const uint to_address_2 = address + 2u;
                const uint to_virtual_3 = to_origin + to_address_2;
                if (to_address_2 < to_size) {
                    to_data[to_virtual_3] = to_items[2u];
                }
                const uint to_address_3 = address + 3u;
                const uint to_virtual_4 = to_origin + to_address_3;
                if (to_address_3 < to_size) {
                    to_data[to_virtual_4] = to_items[3u];
                }
            }
        }
    }
}

static void sum_fours_general(const glift::HostCall& call) {
    glift::host::for_strides(call.size[0], 4,
        [&](const glift::host::Rows& rows) { sum_fours_general_rows(call, rows); });
}

const glift::Binding sum_fours_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24,
        .parameter = 1, .reach = glift::Reach::range},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 32,
        .parameter = 2, .reach = glift::Reach::range},
};
constexpr glift::Parameter sum_fours_parameters[] = {
    {"a_extent", 0, sizeof(sum_fours_direct_parameters::a_extent)},
    {"shift", 4, sizeof(sum_fours_direct_parameters::shift)},
};
const glift::Kernel sum_fours_kernel = {
    .name = "sum_fours",
    .file = "fours.glift",
    .line = 8,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 5,
    .bindings = sum_fours_bindings,
    .direct = {.host = &sum_fours_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &sum_fours_general, .parameter_bytes = 24},
    .wide = {},
    .parameters = sum_fours_parameters,
    .items = {4, 1, 1},
    .longest_loop = {"fours.glift", 12},
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

void sum_fours(const glift::Commands& commands, const glift::Range<Values>& a, const glift::Range<Values>& from,
    uint shift, const glift::Range<Values>& to) {
    glift::Iteration iteration(sum_fours_kernel);
    iteration.each("a", a);
    iteration.any("from", from);
    iteration.any("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {a, from, to});
    if (iteration.is_whole() && a->same_state(from.structure()) && from->same_state(to.structure())
        && !commands.needs_general(sum_fours_kernel, memories, iteration.size())) {
        const sum_fours_direct_parameters parameters = {
            .a_extent = a->extent(),
            .shift = shift,
        };
        commands.dispatch(sum_fours_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const sum_fours_general_parameters parameters = {
            .size = a.size(),
            .from_origin = from.origin(),
            .from_size = from.size(),
            .to_origin = to.origin(),
            .to_size = to.size(),
            .shift = shift,
        };
        iteration.count(from, offsetof(sum_fours_general_parameters, from_size));
        iteration.count(to, offsetof(sum_fours_general_parameters, to_size));
        commands.dispatch(sum_fours_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(sum_fours_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void sum_fours(const glift::Commands& commands, const glift::Range<Values>& from, uint shift,
    const glift::Range<Values>& to) {
    sum_fours(commands, from, from, shift, to);
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

}  // namespace fours
