// Made by gliftc from guards.glift. Changes are lost when it is made again.
#include "guards.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace guards {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// guards.glift:8: double_tiles

namespace {
struct double_tiles_direct_parameters {
    uint tile_extent;
};
static_assert(offsetof(double_tiles_direct_parameters, tile_extent) == 0);

// guards.glift:8: runs kernel double_tiles for the given rows.
GLIFT_HOST_KERNEL
static void double_tiles_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const double_tiles_direct_parameters*>(call.parameters);
    const uint tile_extent = parameters.tile_extent;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x * 64;
            if (tile_extent >= 64u && address <= tile_extent - 64u) {
                // guards.glift:9
                for (uint row_2 = 0u; row_2 < 4u; ++row_2) {
                    // guards.glift:10
                    const uint from_first = address + 16u * row_2;
                    glift::array<uint, 16> from_items = glift::array<uint, 16>{};
                    const uint from_vector = from_first / 4u;
                    glift::host::load_rows(from_data, from_vector, from_items);
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
                    const uint to_vector = from_first / 4u;
                    glift::host::store_rows(to_data, to_vector, to_items);
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

// guards.glift:8: runs kernel double_tiles for the given rows.
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
            if (from_size >= 64u && address <= from_size - 64u && to_size >= 64u && address <= to_size - 64u
                && (address + from_origin) % 4u == 0u && (address + to_origin) % 4u == 0u) {
                // guards.glift:9
                for (uint row_2 = 0u; row_2 < 4u; ++row_2) {
                    // guards.glift:10
                    const uint from_first = address + 16u * row_2;
                    const uint from_virtual = from_first + from_origin;
                    glift::array<uint, 16> from_items = glift::array<uint, 16>{};
                    const uint from_vector = from_virtual / 4u;
                    glift::host::load_rows(from_data, from_vector, from_items);
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
                    const uint to_vector = to_virtual / 4u;
                    glift::host::store_rows(to_data, to_vector, to_items);
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

struct double_tiles_wide_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint to_origin;
    uint to_size;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(double_tiles_wide_parameters, size) == 0);
static_assert(offsetof(double_tiles_wide_parameters, from_origin) == 4);
static_assert(offsetof(double_tiles_wide_parameters, from_size) == 8);
static_assert(offsetof(double_tiles_wide_parameters, to_origin) == 12);
static_assert(offsetof(double_tiles_wide_parameters, to_size) == 16);
static_assert(offsetof(double_tiles_wide_parameters, from_data_address) == 24);
static_assert(offsetof(double_tiles_wide_parameters, to_data_address) == 32);

// guards.glift:8: runs kernel double_tiles for the given rows.
GLIFT_HOST_KERNEL
static void double_tiles_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const double_tiles_wide_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint from_size = parameters.from_size;
    const uint to_origin = parameters.to_origin;
    const uint to_size = parameters.to_size;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x * 64;
            if (from_size >= 64u && address <= from_size - 64u && to_size >= 64u && address <= to_size - 64u) {
                // guards.glift:9
                for (uint row_2 = 0u; row_2 < 4u; ++row_2) {
                    // guards.glift:10
                    const uint from_first = address + 16u * row_2;
                    glift::array<uint, 16> from_items = glift::array<uint, 16>{};
                    for (uint row_3 = 0u; row_3 < 4u; ++row_3) {
                        const uint value = row_3 * 4u;
                        const uint from0_address = from_first + value;
                        const uint from0_virtual = from0_address + from_origin;
                        const std::uint64_t from0_value_at = std::uint64_t(from0_virtual);
                        const uint from0_value = from_data[from0_value_at];
                        from_items[value] = from0_value;
                        const uint from1_virtual = from0_virtual + 1u;
                        const std::uint64_t from1_value_at = std::uint64_t(from1_virtual);
                        const uint from1_value = from_data[from1_value_at];
                        from_items[value + 1u] = from1_value;
                        const uint from2_virtual = from0_virtual + 2u;
                        const std::uint64_t from2_value_at = std::uint64_t(from2_virtual);
                        const uint from2_value = from_data[from2_value_at];
                        from_items[value + 2u] = from2_value;
                        const uint from3_virtual = from0_virtual + 3u;
                        const std::uint64_t from3_value_at = std::uint64_t(from3_virtual);
                        const uint from3_value = from_data[from3_value_at];
                        from_items[value + 3u] = from3_value;
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
                    for (uint row_3 = 0u; row_3 < 4u; ++row_3) {
                        const uint value = row_3 * 4u;
                        const uint to_address = from_first + value;
                        const uint to_virtual = to_address + to_origin;
                        to_data[std::uint64_t(to_virtual)] = to_items[value];
                        const uint to_virtual_2 = to_virtual + 1u;
                        to_data[std::uint64_t(to_virtual_2)] = to_items[value + 1u];
                        const uint to_virtual_3 = to_virtual + 2u;
                        to_data[std::uint64_t(to_virtual_3)] = to_items[value + 2u];
                        const uint to_virtual_4 = to_virtual + 3u;
                        to_data[std::uint64_t(to_virtual_4)] = to_items[value + 3u];
                    }
                }
            } else {
                // guards.glift:9
                for (uint row_2 = 0u; row_2 < 4u; ++row_2) {
                    // guards.glift:10
                    const uint from_first = address + 16u * row_2;
                    glift::array<uint, 16> from_items = glift::array<uint, 16>{};
                    for (uint row_3 = 0u; row_3 < 4u; ++row_3) {
                        const uint value = row_3 * 4u;
                        const uint from0_address = from_first + value;
                        const uint from0_virtual = from0_address + from_origin;
                        const bool from0_value_inside = from0_address < from_size;
                        const std::uint64_t from0_value_at = std::uint64_t(from0_virtual);
                        const uint from0_value = from_data[from0_value_inside ? from0_value_at : std::uint64_t{0u}];
                        from_items[value] = from0_value_inside ? from0_value : 0u;
                        const uint from1_address = from0_address + 1u;
                        const uint from1_virtual = from0_virtual + 1u;
                        const bool from1_value_inside = from1_address < from_size;
                        const std::uint64_t from1_value_at = std::uint64_t(from1_virtual);
                        const uint from1_value = from_data[from1_value_inside ? from1_value_at : std::uint64_t{0u}];
                        from_items[value + 1u] = from1_value_inside ? from1_value : 0u;
                        const uint from2_address = from0_address + 2u;
                        const uint from2_virtual = from0_virtual + 2u;
                        const bool from2_value_inside = from2_address < from_size;
                        const std::uint64_t from2_value_at = std::uint64_t(from2_virtual);
                        const uint from2_value = from_data[from2_value_inside ? from2_value_at : std::uint64_t{0u}];
                        from_items[value + 2u] = from2_value_inside ? from2_value : 0u;
                        const uint from3_address = from0_address + 3u;
                        const uint from3_virtual = from0_virtual + 3u;
                        const bool from3_value_inside = from3_address < from_size;
                        const std::uint64_t from3_value_at = std::uint64_t(from3_virtual);
                        const uint from3_value = from_data[from3_value_inside ? from3_value_at : std::uint64_t{0u}];
                        from_items[value + 3u] = from3_value_inside ? from3_value : 0u;
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
                    for (uint row_3 = 0u; row_3 < 4u; ++row_3) {
                        const uint value = row_3 * 4u;
                        const uint to_address = from_first + value;
                        const uint to_virtual = to_address + to_origin;
                        if (to_address < to_size) {
                            to_data[std::uint64_t(to_virtual)] = to_items[value];
                        }
                        const uint to_address_2 = to_address + 1u;
                        const uint to_virtual_2 = to_virtual + 1u;
                        if (to_address_2 < to_size) {
                            to_data[std::uint64_t(to_virtual_2)] = to_items[value + 1u];
                        }
                        const uint to_address_3 = to_address + 2u;
                        const uint to_virtual_3 = to_virtual + 2u;
                        if (to_address_3 < to_size) {
                            to_data[std::uint64_t(to_virtual_3)] = to_items[value + 2u];
                        }
                        const uint to_address_4 = to_address + 3u;
                        const uint to_virtual_4 = to_virtual + 3u;
                        if (to_address_4 < to_size) {
                            to_data[std::uint64_t(to_virtual_4)] = to_items[value + 3u];
                        }
                    }
                }
            }
        }
    }
}

static void double_tiles_wide(const glift::HostCall& call) {
    glift::host::for_strides(call.size[0], 64,
        [&](const glift::host::Rows& rows) { double_tiles_wide_rows(call, rows); });
}

const glift::Binding double_tiles_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::range},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 32,
        .element_bytes = sizeof(uint), .parameter = 2, .reach = glift::Reach::range},
};
constexpr glift::Parameter double_tiles_parameters[] = {
    {"tile_extent", 0, sizeof(double_tiles_direct_parameters::tile_extent)},
};
}  // namespace

extern const glift::Kernel double_tiles_kernel;
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
    .wide = {.host = &double_tiles_wide, .parameter_bytes = 40},
    .parameters = double_tiles_parameters,
    .items = {64, 1, 1},
    .longest_loop = {"guards.glift", 9},
};

// ----------------------------------------------------------------------------------------------------
// guards.glift:20: add_far

namespace {
struct add_far_direct_parameters {
    uint tile_extent;
    uint far_;
};
static_assert(offsetof(add_far_direct_parameters, tile_extent) == 0);
static_assert(offsetof(add_far_direct_parameters, far_) == 4);

// guards.glift:20: runs kernel add_far for the given rows.
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
            if (tile_extent >= 8u && address <= tile_extent - 8u) {
                // guards.glift:21
                for (uint j = 0u; j < 8u; ++j) {
                    // guards.glift:22
                    const uint i_2 = address + j;
                    // guards.glift:23
                    const uint from_value = from_data[i_2];
                    const uint from_value_2 = from_value;
                    if (from_value_2 > 3u) {
                        // guards.glift:24
                        const uint from_address = i_2 * far_;
                        const bool from_value_inside = from_address < tile_extent;
                        const uint from_value_3 = from_data[from_value_inside ? from_address : 0u];
                        to_data[i_2] = from_value_2 + (from_value_inside ? from_value_3 : 0u);
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
                    const uint from_value_2 = from_value_inside ? from_value : 0u;
                    if (from_value_2 > 3u) {
                        // guards.glift:24
                        const uint from_address = i_2 * far_;
                        const bool from_value_inside_2 = from_address < tile_extent;
                        const uint from_value_3 = from_data[from_value_inside_2 ? from_address : 0u];
                        if (from_value_inside) {
                            to_data[i_2] = from_value_2 + (from_value_inside_2 ? from_value_3 : 0u);
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

// guards.glift:20: runs kernel add_far for the given rows.
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
            if (from_size >= 8u && address <= from_size - 8u && to_size >= 8u && address <= to_size - 8u) {
                // guards.glift:21
                for (uint j = 0u; j < 8u; ++j) {
                    // guards.glift:22
                    const uint i_2 = address + j;
                    // guards.glift:23
                    const uint from_virtual = i_2 + from_origin;
                    const uint from_value = from_data[from_virtual];
                    const uint from_value_2 = from_value;
                    if (from_value_2 > 3u) {
                        // guards.glift:24
                        const uint from_address = i_2 * far_;
                        const uint from_virtual_2 = from_address + from_origin;
                        const bool from_value_inside = from_address < from_size;
                        const uint from_value_3 = from_data[from_value_inside ? from_virtual_2 : 0u];
                        const uint to_virtual = i_2 + to_origin;
                        to_data[to_virtual] = from_value_2 + (from_value_inside ? from_value_3 : 0u);
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
                    const uint from_value_2 = from_value_inside ? from_value : 0u;
                    if (from_value_2 > 3u) {
                        // guards.glift:24
                        const uint from_address = i_2 * far_;
                        const uint from_virtual_2 = from_address + from_origin;
                        const bool from_value_inside_2 = from_address < from_size;
                        const uint from_value_3 = from_data[from_value_inside_2 ? from_virtual_2 : 0u];
                        const uint to_virtual = i_2 + to_origin;
                        if (i_2 < to_size) {
                            to_data[to_virtual] = from_value_2 + (from_value_inside_2 ? from_value_3 : 0u);
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

struct add_far_wide_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint to_origin;
    uint to_size;
    uint far_;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(add_far_wide_parameters, size) == 0);
static_assert(offsetof(add_far_wide_parameters, from_origin) == 4);
static_assert(offsetof(add_far_wide_parameters, from_size) == 8);
static_assert(offsetof(add_far_wide_parameters, to_origin) == 12);
static_assert(offsetof(add_far_wide_parameters, to_size) == 16);
static_assert(offsetof(add_far_wide_parameters, far_) == 20);
static_assert(offsetof(add_far_wide_parameters, from_data_address) == 24);
static_assert(offsetof(add_far_wide_parameters, to_data_address) == 32);

// guards.glift:20: runs kernel add_far for the given rows.
GLIFT_HOST_KERNEL
static void add_far_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const add_far_wide_parameters*>(call.parameters);
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
            if (from_size >= 8u && address <= from_size - 8u && to_size >= 8u && address <= to_size - 8u) {
                // guards.glift:21
                for (uint j = 0u; j < 8u; ++j) {
                    // guards.glift:22
                    const uint i_2 = address + j;
                    // guards.glift:23
                    const uint from_virtual = i_2 + from_origin;
                    const std::uint64_t from_value_at = std::uint64_t(from_virtual);
                    const uint from_value = from_data[from_value_at];
                    const uint from_value_2 = from_value;
                    if (from_value_2 > 3u) {
                        // guards.glift:24
                        const uint from_address = i_2 * far_;
                        const uint from_virtual_2 = from_address + from_origin;
                        const bool from_value_inside = from_address < from_size;
                        const std::uint64_t from_value_at_2 = std::uint64_t(from_virtual_2);
                        const uint from_value_3 = from_data[from_value_inside ? from_value_at_2 : std::uint64_t{0u}];
                        const uint to_virtual = i_2 + to_origin;
                        to_data[std::uint64_t(to_virtual)] = from_value_2 + (from_value_inside ? from_value_3 : 0u);
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
                    const std::uint64_t from_value_at = std::uint64_t(from_virtual);
                    const uint from_value = from_data[from_value_inside ? from_value_at : std::uint64_t{0u}];
                    const uint from_value_2 = from_value_inside ? from_value : 0u;
                    if (from_value_2 > 3u) {
                        // guards.glift:24
                        const uint from_address = i_2 * far_;
                        const uint from_virtual_2 = from_address + from_origin;
                        const bool from_value_inside_2 = from_address < from_size;
                        const std::uint64_t from_value_at_2 = std::uint64_t(from_virtual_2);
                        const uint from_value_3 = from_data[from_value_inside_2 ? from_value_at_2 : std::uint64_t{0u}];
                        const uint to_virtual = i_2 + to_origin;
                        if (i_2 < to_size) {
                            to_data[std::uint64_t(to_virtual)] = from_value_2
                                + (from_value_inside_2 ? from_value_3 : 0u);
                        }
                    }
                }
            }
        }
    }
}

static void add_far_wide(const glift::HostCall& call) {
    glift::host::for_strides(call.size[0], 8, [&](const glift::host::Rows& rows) { add_far_wide_rows(call, rows); });
}

const glift::Binding add_far_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::range},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 32,
        .element_bytes = sizeof(uint), .parameter = 2, .reach = glift::Reach::range},
};
constexpr glift::Parameter add_far_parameters[] = {
    {"tile_extent", 0, sizeof(add_far_direct_parameters::tile_extent)},
    {"far", 4, sizeof(add_far_direct_parameters::far_)},
};
}  // namespace

extern const glift::Kernel add_far_kernel;
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
    .wide = {.host = &add_far_wide, .parameter_bytes = 40},
    .parameters = add_far_parameters,
    .items = {8, 1, 1},
    .longest_loop = {"guards.glift", 21},
};

}  // namespace guards

