// Made by gliftc from guards.glift. Changes are lost when it is made again.
#include "guards.glift.hpp"

#include <glift/host/image.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>

#include <optional>

namespace guards {

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
// guards.glift:8: double_tiles

struct double_tiles_direct_parameters {
    uint tile_extent;
};
static_assert(offsetof(double_tiles_direct_parameters, tile_extent) == 0);

// guards.glift:8: double_tiles, some rows.
GLIFT_HOST_KERNEL
static void double_tiles_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const double_tiles_direct_parameters*>(call.parameters);
    const uint tile_extent = parameters.tile_extent;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x * 64;
            if (glift::host::fits(address, 64u, tile_extent)) {
                // guards.glift:9
                for (uint row_2 = 0u; row_2 < 4u; ++row_2) {
                    // guards.glift:10
                    const uint from_first = address + 16u * row_2;
                    glift::array<uint, 16> from_items = glift::array<uint, 16>{};
                    {
                        const uint from_vector = from_first / 4u;
                        glift::host::load_rows(from_data, from_vector, from_items);
                    }
                    const glift::array<uint, 16>& items = from_items;
                    // guards.glift:11
                    glift::array<uint, 16> results{};
                    // guards.glift:12
                    for (uint j = 0u; j < 16u; ++j) {
                        // guards.glift:13
                        results[j] = 2u * items[j];
                    }
                    // guards.glift:15
                    const glift::array<uint, 16>& to_items = results;
                    {
                        const uint to_vector = from_first / 4u;
                        glift::host::store_rows(to_data, to_vector, to_items);
                    }
                }
            } else {
                // guards.glift:9
                for (uint row_2 = 0u; row_2 < 4u; ++row_2) {
                    // guards.glift:10
                    const uint from_first = address + 16u * row_2;
                    glift::array<uint, 16> from_items = glift::array<uint, 16>{};
                    const bool test = from_first < tile_extent && tile_extent - from_first >= 16u;
                    if (test) {
                        const uint from_vector = from_first / 4u;
                        glift::host::load_rows(from_data, from_vector, from_items);
                    } else {
                        for (uint row_3 = 0u; row_3 < 4u; ++row_3) {
                            const uint value = row_3 * 4u;
                            const uint from0_address = from_first + value;
                            const bool from0_value_inside = from0_address < tile_extent;
                            const uint from0_value = from_data[from0_value_inside ? from0_address : 0u];
                            from_items[value] = from0_value_inside ? from0_value : 0u;
                            const uint from1_address = from0_address + 1u;
                            const bool from1_value_inside = from1_address < tile_extent;
                            const uint from1_value = from_data[from1_value_inside ? from1_address : 0u];
                            from_items[value + 1u] = from1_value_inside ? from1_value : 0u;
                            const uint from2_address = from0_address + 2u;
                            const bool from2_value_inside = from2_address < tile_extent;
                            const uint from2_value = from_data[from2_value_inside ? from2_address : 0u];
                            from_items[value + 2u] = from2_value_inside ? from2_value : 0u;
                            const uint from3_address = from0_address + 3u;
                            const bool from3_value_inside = from3_address < tile_extent;
                            const uint from3_value = from_data[from3_value_inside ? from3_address : 0u];
                            from_items[value + 3u] = from3_value_inside ? from3_value : 0u;
                        }
                    }
                    const glift::array<uint, 16>& items = from_items;
                    // guards.glift:11
                    glift::array<uint, 16> results{};
                    // guards.glift:12
                    for (uint j = 0u; j < 16u; ++j) {
                        // guards.glift:13
                        results[j] = 2u * items[j];
                    }
                    // guards.glift:15
                    const glift::array<uint, 16>& to_items = results;
                    if (test) {
                        const uint to_vector = from_first / 4u;
                        glift::host::store_rows(to_data, to_vector, to_items);
                    } else {
                        for (uint row_3 = 0u; row_3 < 4u; ++row_3) {
                            const uint value = row_3 * 4u;
                            const uint to_address = from_first + value;
                            if (to_address < tile_extent) {
                                to_data[to_address] = to_items[value];
                            }
                            const uint to_address_2 = to_address + 1u;
                            if (to_address_2 < tile_extent) {
                                to_data[to_address_2] = to_items[value + 1u];
                            }
                            const uint to_address_3 = to_address + 2u;
                            if (to_address_3 < tile_extent) {
                                to_data[to_address_3] = to_items[value + 2u];
                            }
                            const uint to_address_4 = to_address + 3u;
                            if (to_address_4 < tile_extent) {
                                to_data[to_address_4] = to_items[value + 3u];
                            }
                        }
                    }
                }
            }
        }
    }
}

static void double_tiles_direct(const glift::HostCall& call) {
    glift::host::for_strides(call.size[0], 64,
        [&](const glift::host::Rows& rows) { double_tiles_direct_rows(call, rows); });
}

struct double_tiles_general_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint to_origin;
    uint to_size;
};
static_assert(offsetof(double_tiles_general_parameters, size) == 0);
static_assert(offsetof(double_tiles_general_parameters, from_origin) == 4);
static_assert(offsetof(double_tiles_general_parameters, from_size) == 8);
static_assert(offsetof(double_tiles_general_parameters, to_origin) == 12);
static_assert(offsetof(double_tiles_general_parameters, to_size) == 16);

// guards.glift:8: double_tiles, some rows.
GLIFT_HOST_KERNEL
static void double_tiles_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const double_tiles_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint from_size = parameters.from_size;
    const uint to_origin = parameters.to_origin;
    const uint to_size = parameters.to_size;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x * 64;
            if (glift::host::fits(address, 64u, from_size) && glift::host::fits(address, 64u, to_size)
                && (address + from_origin) % 4u == 0u && (address + to_origin) % 4u == 0u) {
                // guards.glift:9
                for (uint row_2 = 0u; row_2 < 4u; ++row_2) {
                    // guards.glift:10
                    const uint from_first = address + 16u * row_2;
                    const uint from_virtual = from_first + from_origin;
                    glift::array<uint, 16> from_items = glift::array<uint, 16>{};
                    {
                        const uint from_vector = from_virtual / 4u;
                        glift::host::load_rows(from_data, from_vector, from_items);
                    }
                    const glift::array<uint, 16>& items = from_items;
                    // guards.glift:11
                    glift::array<uint, 16> results{};
                    // guards.glift:12
                    for (uint j = 0u; j < 16u; ++j) {
                        // guards.glift:13
                        results[j] = 2u * items[j];
                    }
                    // guards.glift:15
                    const uint to_virtual = from_first + to_origin;
                    const glift::array<uint, 16>& to_items = results;
                    {
                        const uint to_vector = to_virtual / 4u;
                        glift::host::store_rows(to_data, to_vector, to_items);
                    }
                }
            } else {
                // guards.glift:9
                for (uint row_2 = 0u; row_2 < 4u; ++row_2) {
                    // guards.glift:10
                    const uint from_first = address + 16u * row_2;
                    const uint from_virtual = from_first + from_origin;
                    glift::array<uint, 16> from_items = glift::array<uint, 16>{};
                    if (from_first < from_size && from_size - from_first >= 16u && from_virtual % 4u == 0u) {
                        const uint from_vector = from_virtual / 4u;
                        glift::host::load_rows(from_data, from_vector, from_items);
                    } else {
                        for (uint row_3 = 0u; row_3 < 4u; ++row_3) {
                            const uint value = row_3 * 4u;
                            const uint from0_address = from_first + value;
                            const uint from0_virtual = from0_address + from_origin;
                            const bool from0_value_inside = from0_address < from_size;
                            const uint from0_value = from_data[from0_value_inside ? from0_virtual : 0u];
                            from_items[value] = from0_value_inside ? from0_value : 0u;
                            const uint from1_address = from0_address + 1u;
                            const uint from1_virtual = from0_virtual + 1u;
                            const bool from1_value_inside = from1_address < from_size;
                            const uint from1_value = from_data[from1_value_inside ? from1_virtual : 0u];
                            from_items[value + 1u] = from1_value_inside ? from1_value : 0u;
                            const uint from2_address = from0_address + 2u;
                            const uint from2_virtual = from0_virtual + 2u;
                            const bool from2_value_inside = from2_address < from_size;
                            const uint from2_value = from_data[from2_value_inside ? from2_virtual : 0u];
                            from_items[value + 2u] = from2_value_inside ? from2_value : 0u;
                            const uint from3_address = from0_address + 3u;
                            const uint from3_virtual = from0_virtual + 3u;
                            const bool from3_value_inside = from3_address < from_size;
                            const uint from3_value = from_data[from3_value_inside ? from3_virtual : 0u];
                            from_items[value + 3u] = from3_value_inside ? from3_value : 0u;
                        }
                    }
                    const glift::array<uint, 16>& items = from_items;
                    // guards.glift:11
                    glift::array<uint, 16> results{};
                    // guards.glift:12
                    for (uint j = 0u; j < 16u; ++j) {
                        // guards.glift:13
                        results[j] = 2u * items[j];
                    }
                    // guards.glift:15
                    const uint to_virtual = from_first + to_origin;
                    const glift::array<uint, 16>& to_items = results;
                    if (from_first < to_size && to_size - from_first >= 16u && to_virtual % 4u == 0u) {
                        const uint to_vector = to_virtual / 4u;
                        glift::host::store_rows(to_data, to_vector, to_items);
                    } else {
                        for (uint row_3 = 0u; row_3 < 4u; ++row_3) {
                            const uint value = row_3 * 4u;
                            const uint to_address = from_first + value;
                            const uint to_virtual_2 = to_address + to_origin;
                            if (to_address < to_size) {
                                to_data[to_virtual_2] = to_items[value];
                            }
                            const uint to_address_2 = to_address + 1u;
                            const uint to_virtual_3 = to_virtual_2 + 1u;
                            if (to_address_2 < to_size) {
                                to_data[to_virtual_3] = to_items[value + 1u];
                            }
                            const uint to_address_3 = to_address + 2u;
                            const uint to_virtual_4 = to_virtual_2 + 2u;
                            if (to_address_3 < to_size) {
                                to_data[to_virtual_4] = to_items[value + 2u];
                            }
                            const uint to_address_4 = to_address + 3u;
                            const uint to_virtual_5 = to_virtual_2 + 3u;
                            if (to_address_4 < to_size) {
                                to_data[to_virtual_5] = to_items[value + 3u];
                            }
                        }
                    }
                }
            }
        }
    }
}

static void double_tiles_general(const glift::HostCall& call) {
    glift::host::for_strides(call.size[0], 64,
        [&](const glift::host::Rows& rows) { double_tiles_general_rows(call, rows); });
}

const glift::Binding double_tiles_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24,
        .parameter = 1, .reach = glift::Reach::range},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 32,
        .parameter = 2, .reach = glift::Reach::range},
};
constexpr glift::Parameter double_tiles_parameters[] = {
    {"tile_extent", 0, sizeof(double_tiles_direct_parameters::tile_extent)},
};
const glift::Kernel double_tiles_kernel = {
    .name = "double_tiles",
    .file = "guards.glift",
    .line = 8,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 158,
    .bindings = double_tiles_bindings,
    .direct = {.host = &double_tiles_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &double_tiles_general, .parameter_bytes = 20},
    .wide = {},
    .parameters = double_tiles_parameters,
    .items = {64, 1, 1},
    .longest_loop = {"guards.glift", 9},
};

// ----------------------------------------------------------------------------------------------------
// guards.glift:20: add_far

struct add_far_direct_parameters {
    uint tile_extent;
    uint far_;
};
static_assert(offsetof(add_far_direct_parameters, tile_extent) == 0);
static_assert(offsetof(add_far_direct_parameters, far_) == 4);

// guards.glift:20: add_far, some rows.
GLIFT_HOST_KERNEL
static void add_far_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const add_far_direct_parameters*>(call.parameters);
    const uint tile_extent = parameters.tile_extent;
    const uint far_ = parameters.far_;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x * 8;
            if (glift::host::fits(address, 8u, tile_extent)) {
                // guards.glift:21
                for (uint j = 0u; j < 8u; ++j) {
                    // guards.glift:22
                    const uint i_2 = address + j;
                    // guards.glift:23
                    const uint from_value = from_data[i_2];
                    const uint value = from_value;
                    if (value > 3u) {
                        // guards.glift:24
                        const uint from_address = i_2 * far_;
                        const bool from_value_inside = from_address < tile_extent;
                        const uint from_value_2 = from_data[from_value_inside ? from_address : 0u];
                        {
                            to_data[i_2] = value + (from_value_inside ? from_value_2 : 0u);
                        }
                    }
                }
            } else {
                // guards.glift:21
                for (uint j = 0u; j < 8u; ++j) {
                    // guards.glift:22
                    const uint i_2 = address + j;
                    // guards.glift:23
                    const bool from_value_inside = i_2 < tile_extent;
                    const uint from_value = from_data[from_value_inside ? i_2 : 0u];
                    const uint value = from_value_inside ? from_value : 0u;
                    if (value > 3u) {
                        // guards.glift:24
                        const uint from_address = i_2 * far_;
                        const bool from_value_inside_2 = from_address < tile_extent;
                        const uint from_value_2 = from_data[from_value_inside_2 ? from_address : 0u];
                        if (from_value_inside) {
                            to_data[i_2] = value + (from_value_inside_2 ? from_value_2 : 0u);
                        }
                    }
                }
            }
        }
    }
}

static void add_far_direct(const glift::HostCall& call) {
    glift::host::for_strides(call.size[0], 8, [&](const glift::host::Rows& rows) { add_far_direct_rows(call, rows); });
}

struct add_far_general_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint to_origin;
    uint to_size;
    uint far_;
};
static_assert(offsetof(add_far_general_parameters, size) == 0);
static_assert(offsetof(add_far_general_parameters, from_origin) == 4);
static_assert(offsetof(add_far_general_parameters, from_size) == 8);
static_assert(offsetof(add_far_general_parameters, to_origin) == 12);
static_assert(offsetof(add_far_general_parameters, to_size) == 16);
static_assert(offsetof(add_far_general_parameters, far_) == 20);

// guards.glift:20: add_far, some rows.
GLIFT_HOST_KERNEL
static void add_far_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const add_far_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint from_size = parameters.from_size;
    const uint to_origin = parameters.to_origin;
    const uint to_size = parameters.to_size;
    const uint far_ = parameters.far_;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x * 8;
            if (glift::host::fits(address, 8u, from_size) && glift::host::fits(address, 8u, to_size)) {
                // guards.glift:21
                for (uint j = 0u; j < 8u; ++j) {
                    // guards.glift:22
                    const uint i_2 = address + j;
                    // guards.glift:23
                    const uint from_virtual = i_2 + from_origin;
                    const uint from_value = from_data[from_virtual];
                    const uint value = from_value;
                    if (value > 3u) {
                        // guards.glift:24
                        const uint from_address = i_2 * far_;
                        const uint from_virtual_2 = from_address + from_origin;
                        const bool from_value_inside = from_address < from_size;
                        const uint from_value_2 = from_data[from_value_inside ? from_virtual_2 : 0u];
                        const uint to_virtual = i_2 + to_origin;
                        {
                            to_data[to_virtual] = value + (from_value_inside ? from_value_2 : 0u);
                        }
                    }
                }
            } else {
                // guards.glift:21
                for (uint j = 0u; j < 8u; ++j) {
                    // guards.glift:22
                    const uint i_2 = address + j;
                    // guards.glift:23
                    const uint from_virtual = i_2 + from_origin;
                    const bool from_value_inside = i_2 < from_size;
                    const uint from_value = from_data[from_value_inside ? from_virtual : 0u];
                    const uint value = from_value_inside ? from_value : 0u;
                    if (value > 3u) {
                        // guards.glift:24
                        const uint from_address = i_2 * far_;
                        const uint from_virtual_2 = from_address + from_origin;
                        const bool from_value_inside_2 = from_address < from_size;
                        const uint from_value_2 = from_data[from_value_inside_2 ? from_virtual_2 : 0u];
                        const uint to_virtual = i_2 + to_origin;
                        if (i_2 < to_size) {
                            to_data[to_virtual] = value + (from_value_inside_2 ? from_value_2 : 0u);
                        }
                    }
                }
            }
        }
    }
}

static void add_far_general(const glift::HostCall& call) {
    glift::host::for_strides(call.size[0], 8, [&](const glift::host::Rows& rows) { add_far_general_rows(call, rows); });
}

const glift::Binding add_far_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24,
        .parameter = 1, .reach = glift::Reach::range},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 32,
        .parameter = 2, .reach = glift::Reach::range},
};
constexpr glift::Parameter add_far_parameters[] = {
    {"tile_extent", 0, sizeof(add_far_direct_parameters::tile_extent)},
    {"far", 4, sizeof(add_far_direct_parameters::far_)},
};
const glift::Kernel add_far_kernel = {
    .name = "add_far",
    .file = "guards.glift",
    .line = 20,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 9,
    .bindings = add_far_bindings,
    .direct = {.host = &add_far_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &add_far_general, .parameter_bytes = 24},
    .wide = {},
    .parameters = add_far_parameters,
    .items = {8, 1, 1},
    .longest_loop = {"guards.glift", 21},
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

void double_tiles(const glift::Commands& commands, const glift::Range<Values>& tile, const glift::Range<Values>& from,
    const glift::Range<Values>& to) {
    glift::Iteration iteration(double_tiles_kernel);
    iteration.each("tile", tile);
    iteration.any("from", from);
    iteration.any("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {tile, from, to});
    if (iteration.is_whole() && tile->same_state(from.structure()) && from->same_state(to.structure())
        && !commands.needs_general(double_tiles_kernel, memories, iteration.size())) {
        const double_tiles_direct_parameters parameters = {
            .tile_extent = tile->extent(),
        };
        commands.dispatch(double_tiles_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const double_tiles_general_parameters parameters = {
            .size = tile.size(),
            .from_origin = from.origin(),
            .from_size = from.size(),
            .to_origin = to.origin(),
            .to_size = to.size(),
        };
        iteration.count(from, offsetof(double_tiles_general_parameters, from_size));
        iteration.count(to, offsetof(double_tiles_general_parameters, to_size));
        commands.dispatch(double_tiles_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(double_tiles_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void double_tiles(const glift::Commands& commands, const glift::Range<Values>& from, const glift::Range<Values>& to) {
    double_tiles(commands, from, from, to);
}

void add_far(const glift::Commands& commands, const glift::Range<Values>& tile, const glift::Range<Values>& from,
    uint far_, const glift::Range<Values>& to) {
    glift::Iteration iteration(add_far_kernel);
    iteration.each("tile", tile);
    iteration.any("from", from);
    iteration.any("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {tile, from, to});
    if (iteration.is_whole() && tile->same_state(from.structure()) && from->same_state(to.structure())
        && !commands.needs_general(add_far_kernel, memories, iteration.size())) {
        const add_far_direct_parameters parameters = {
            .tile_extent = tile->extent(),
            .far_ = far_,
        };
        commands.dispatch(add_far_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const add_far_general_parameters parameters = {
            .size = tile.size(),
            .from_origin = from.origin(),
            .from_size = from.size(),
            .to_origin = to.origin(),
            .to_size = to.size(),
            .far_ = far_,
        };
        iteration.count(from, offsetof(add_far_general_parameters, from_size));
        iteration.count(to, offsetof(add_far_general_parameters, to_size));
        commands.dispatch(add_far_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(add_far_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void add_far(const glift::Commands& commands, const glift::Range<Values>& from, uint far_,
    const glift::Range<Values>& to) {
    add_far(commands, from, from, far_, to);
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

}  // namespace guards
