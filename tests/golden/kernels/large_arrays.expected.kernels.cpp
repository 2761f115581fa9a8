// Made by gliftc from large_arrays.glift. Changes are lost when it is made again.
#include "large_arrays.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace large_arrays {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// large_arrays.glift:9: count_digits

namespace {
struct count_digits_direct_parameters {
    uint row_extent;
};
static_assert(offsetof(count_digits_direct_parameters, row_extent) == 0);

// large_arrays.glift:9: runs kernel count_digits for the given rows.
GLIFT_HOST_KERNEL
static void count_digits_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const count_digits_direct_parameters*>(call.parameters);
    const uint row_extent = parameters.row_extent;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* counts_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x * 256;
            if (row_extent >= 256u && address <= row_extent - 256u) {
                // large_arrays.glift:10
                glift::array<uint, 256> found;
                for (uint found_at = 0u; found_at < 256u; ++found_at) {
                    found[found_at] = 0u;
                }
                // large_arrays.glift:11
                for (uint k = 0u; k < 256u; ++k) {
                    // large_arrays.glift:12
                    const uint from_address = address + k;
                    const uint from_value = from_data[from_address];
                    const uint value = from_value & 255u;
                    found[value] += 1u;
                }
                // large_arrays.glift:14
                for (uint d = 0u; d < 256u; ++d) {
                    // large_arrays.glift:15
                    const uint counts_address = address + d;
                    counts_data[counts_address] = found[d];
                }
            } else {
                // large_arrays.glift:10
                glift::array<uint, 256> found;
                for (uint found_at = 0u; found_at < 256u; ++found_at) {
                    found[found_at] = 0u;
                }
                // large_arrays.glift:11
                for (uint k = 0u; k < 256u; ++k) {
                    // large_arrays.glift:12
                    const uint from_address = address + k;
                    const bool from_value_inside = from_address < row_extent;
                    const uint from_value = from_data[from_value_inside ? from_address : 0u];
                    const uint value = (from_value_inside ? from_value : 0u) & 255u;
                    found[value] += 1u;
                }
                // large_arrays.glift:14
                for (uint d = 0u; d < 256u; ++d) {
                    // large_arrays.glift:15
                    const uint counts_address = address + d;
                    if (counts_address < row_extent) {
                        counts_data[counts_address] = found[d];
                    }
                }
            }
        }
    }
}

static void count_digits_direct(const glift::HostCall& call) {
    glift::host::for_strides(call.size[0], 256,
        [&](const glift::host::Rows& rows) { count_digits_direct_rows(call, rows); });
}

struct count_digits_general_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint counts_origin;
    uint counts_size;
};
static_assert(offsetof(count_digits_general_parameters, size) == 0);
static_assert(offsetof(count_digits_general_parameters, from_origin) == 4);
static_assert(offsetof(count_digits_general_parameters, from_size) == 8);
static_assert(offsetof(count_digits_general_parameters, counts_origin) == 12);
static_assert(offsetof(count_digits_general_parameters, counts_size) == 16);

// large_arrays.glift:9: runs kernel count_digits for the given rows.
GLIFT_HOST_KERNEL
static void count_digits_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const count_digits_general_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint from_size = parameters.from_size;
    const uint counts_origin = parameters.counts_origin;
    const uint counts_size = parameters.counts_size;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* counts_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x * 256;
            if (from_size >= 256u && address <= from_size - 256u && counts_size >= 256u
                && address <= counts_size - 256u) {
                // large_arrays.glift:10
                glift::array<uint, 256> found;
                for (uint found_at = 0u; found_at < 256u; ++found_at) {
                    found[found_at] = 0u;
                }
                // large_arrays.glift:11
                for (uint k = 0u; k < 256u; ++k) {
                    // large_arrays.glift:12
                    const uint from_address = address + k;
                    const uint from_virtual = from_address + from_origin;
                    const uint from_value = from_data[from_virtual];
                    const uint value = from_value & 255u;
                    found[value] += 1u;
                }
                // large_arrays.glift:14
                for (uint d = 0u; d < 256u; ++d) {
                    // large_arrays.glift:15
                    const uint counts_address = address + d;
                    const uint counts_virtual = counts_address + counts_origin;
                    counts_data[counts_virtual] = found[d];
                }
            } else {
                // large_arrays.glift:10
                glift::array<uint, 256> found;
                for (uint found_at = 0u; found_at < 256u; ++found_at) {
                    found[found_at] = 0u;
                }
                // large_arrays.glift:11
                for (uint k = 0u; k < 256u; ++k) {
                    // large_arrays.glift:12
                    const uint from_address = address + k;
                    const uint from_virtual = from_address + from_origin;
                    const bool from_value_inside = from_address < from_size;
                    const uint from_value = from_data[from_value_inside ? from_virtual : 0u];
                    const uint value = (from_value_inside ? from_value : 0u) & 255u;
                    found[value] += 1u;
                }
                // large_arrays.glift:14
                for (uint d = 0u; d < 256u; ++d) {
                    // large_arrays.glift:15
                    const uint counts_address = address + d;
                    const uint counts_virtual = counts_address + counts_origin;
                    if (counts_address < counts_size) {
                        counts_data[counts_virtual] = found[d];
                    }
                }
            }
        }
    }
}

static void count_digits_general(const glift::HostCall& call) {
    glift::host::for_strides(call.size[0], 256,
        [&](const glift::host::Rows& rows) { count_digits_general_rows(call, rows); });
}

struct count_digits_wide_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint counts_origin;
    uint counts_size;
    std::uint64_t from_data_address;
    std::uint64_t counts_data_address;
};
static_assert(offsetof(count_digits_wide_parameters, size) == 0);
static_assert(offsetof(count_digits_wide_parameters, from_origin) == 4);
static_assert(offsetof(count_digits_wide_parameters, from_size) == 8);
static_assert(offsetof(count_digits_wide_parameters, counts_origin) == 12);
static_assert(offsetof(count_digits_wide_parameters, counts_size) == 16);
static_assert(offsetof(count_digits_wide_parameters, from_data_address) == 24);
static_assert(offsetof(count_digits_wide_parameters, counts_data_address) == 32);

// large_arrays.glift:9: runs kernel count_digits for the given rows.
GLIFT_HOST_KERNEL
static void count_digits_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const count_digits_wide_parameters*>(call.parameters);
    const uint from_origin = parameters.from_origin;
    const uint from_size = parameters.from_size;
    const uint counts_origin = parameters.counts_origin;
    const uint counts_size = parameters.counts_size;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* counts_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x * 256;
            if (from_size >= 256u && address <= from_size - 256u && counts_size >= 256u
                && address <= counts_size - 256u) {
                // large_arrays.glift:10
                glift::array<uint, 256> found;
                for (uint found_at = 0u; found_at < 256u; ++found_at) {
                    found[found_at] = 0u;
                }
                // large_arrays.glift:11
                for (uint k = 0u; k < 256u; ++k) {
                    // large_arrays.glift:12
                    const uint from_address = address + k;
                    const uint from_virtual = from_address + from_origin;
                    const std::uint64_t from_value_at = std::uint64_t(from_virtual);
                    const uint from_value = from_data[from_value_at];
                    const uint value = from_value & 255u;
                    found[value] += 1u;
                }
                // large_arrays.glift:14
                for (uint d = 0u; d < 256u; ++d) {
                    // large_arrays.glift:15
                    const uint counts_address = address + d;
                    const uint counts_virtual = counts_address + counts_origin;
                    counts_data[std::uint64_t(counts_virtual)] = found[d];
                }
            } else {
                // large_arrays.glift:10
                glift::array<uint, 256> found;
                for (uint found_at = 0u; found_at < 256u; ++found_at) {
                    found[found_at] = 0u;
                }
                // large_arrays.glift:11
                for (uint k = 0u; k < 256u; ++k) {
                    // large_arrays.glift:12
                    const uint from_address = address + k;
                    const uint from_virtual = from_address + from_origin;
                    const bool from_value_inside = from_address < from_size;
                    const std::uint64_t from_value_at = std::uint64_t(from_virtual);
                    const uint from_value = from_data[from_value_inside ? from_value_at : std::uint64_t{0u}];
                    const uint value = (from_value_inside ? from_value : 0u) & 255u;
                    found[value] += 1u;
                }
                // large_arrays.glift:14
                for (uint d = 0u; d < 256u; ++d) {
                    // large_arrays.glift:15
                    const uint counts_address = address + d;
                    const uint counts_virtual = counts_address + counts_origin;
                    if (counts_address < counts_size) {
                        counts_data[std::uint64_t(counts_virtual)] = found[d];
                    }
                }
            }
        }
    }
}

static void count_digits_wide(const glift::HostCall& call) {
    glift::host::for_strides(call.size[0], 256,
        [&](const glift::host::Rows& rows) { count_digits_wide_rows(call, rows); });
}

const glift::Binding count_digits_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::range},
    {.name = "counts.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 32,
        .element_bytes = sizeof(uint), .parameter = 2, .reach = glift::Reach::range},
};
constexpr glift::Parameter count_digits_parameters[] = {
    {"row_extent", 0, sizeof(count_digits_direct_parameters::row_extent)},
};
}  // namespace

extern const glift::Kernel count_digits_kernel;
const glift::Kernel count_digits_kernel = {
    .name = "count_digits",
    .file = "large_arrays.glift",
    .line = 9,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 771,
    .bindings = count_digits_bindings,
    .direct = {.host = &count_digits_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &count_digits_general, .parameter_bytes = 20},
    .wide = {.host = &count_digits_wide, .parameter_bytes = 40},
    .parameters = count_digits_parameters,
    .items = {256, 1, 1},
    .longest_loop = {"large_arrays.glift", 14},
};

// ----------------------------------------------------------------------------------------------------
// large_arrays.glift:19: corners

namespace {
struct corners_direct_parameters {
    uint i_extent;
};
static_assert(offsetof(corners_direct_parameters, i_extent) == 0);

// large_arrays.glift:19: runs kernel corners for the given rows.
GLIFT_HOST_KERNEL
static void corners_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            uint* to_data_row = glift::host::row_pointer(to_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint address = row.begin + static_cast<uint>(i);
                // large_arrays.glift:20
                glift::array<glift::array<float3, 2>, 80> corners;
                for (uint corners_at = 0u; corners_at < 80u; ++corners_at) {
                    for (uint corners_at_2 = 0u; corners_at_2 < 2u; ++corners_at_2) {
                        corners[corners_at][corners_at_2] = float3(0.0f);
                    }
                }
                // large_arrays.glift:21
                const uint value = address % 80u;
                const uint value_2 = address & 1u;
                corners[value][value_2].y += 5.0f;
                // large_arrays.glift:22
                to_data_row[i] = glift::convert<uint>(corners[value][1u].y);
            }
        }
    }
}

static void corners_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { corners_direct_rows(call, rows); });
}

struct corners_general_parameters {
    uint size;
    uint to_origin;
    uint to_size;
};
static_assert(offsetof(corners_general_parameters, size) == 0);
static_assert(offsetof(corners_general_parameters, to_origin) == 4);
static_assert(offsetof(corners_general_parameters, to_size) == 8);

// large_arrays.glift:19: runs kernel corners for the given rows.
GLIFT_HOST_KERNEL
static void corners_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const corners_general_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    const uint to_size = parameters.to_size;
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // large_arrays.glift:20
            glift::array<glift::array<float3, 2>, 80> corners;
            for (uint corners_at = 0u; corners_at < 80u; ++corners_at) {
                for (uint corners_at_2 = 0u; corners_at_2 < 2u; ++corners_at_2) {
                    corners[corners_at][corners_at_2] = float3(0.0f);
                }
            }
            // large_arrays.glift:21
            const uint value = address % 80u;
            const uint value_2 = address & 1u;
            corners[value][value_2].y += 5.0f;
            // large_arrays.glift:22
            const uint to_virtual = to_origin + address;
            if (address < to_size) {
                to_data[to_virtual] = glift::convert<uint>(corners[value][1u].y);
            }
        }
    }
}

static void corners_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { corners_general_rows(call, rows); });
}

struct corners_wide_parameters {
    uint size;
    uint to_origin;
    uint to_size;
    std::uint64_t to_data_address;
};
static_assert(offsetof(corners_wide_parameters, size) == 0);
static_assert(offsetof(corners_wide_parameters, to_origin) == 4);
static_assert(offsetof(corners_wide_parameters, to_size) == 8);
static_assert(offsetof(corners_wide_parameters, to_data_address) == 16);

// large_arrays.glift:19: runs kernel corners for the given rows.
GLIFT_HOST_KERNEL
static void corners_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const corners_wide_parameters*>(call.parameters);
    const uint to_origin = parameters.to_origin;
    const uint to_size = parameters.to_size;
    uint* to_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // large_arrays.glift:20
            glift::array<glift::array<float3, 2>, 80> corners;
            for (uint corners_at = 0u; corners_at < 80u; ++corners_at) {
                for (uint corners_at_2 = 0u; corners_at_2 < 2u; ++corners_at_2) {
                    corners[corners_at][corners_at_2] = float3(0.0f);
                }
            }
            // large_arrays.glift:21
            const uint value = address % 80u;
            const uint value_2 = address & 1u;
            corners[value][value_2].y += 5.0f;
            // large_arrays.glift:22
            const uint to_virtual = to_origin + address;
            if (address < to_size) {
                to_data[std::uint64_t(to_virtual)] = glift::convert<uint>(corners[value][1u].y);
            }
        }
    }
}

static void corners_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { corners_wide_rows(call, rows); });
}

const glift::Binding corners_bindings[] = {
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 16,
        .element_bytes = sizeof(uint)},
};
constexpr glift::Parameter corners_parameters[] = {
    {"i_extent", 0, sizeof(corners_direct_parameters::i_extent)},
};
}  // namespace

extern const glift::Kernel corners_kernel;
const glift::Kernel corners_kernel = {
    .name = "corners",
    .file = "large_arrays.glift",
    .line = 19,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 322,
    .bindings = corners_bindings,
    .direct = {.host = &corners_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &corners_general, .parameter_bytes = 12},
    .wide = {.host = &corners_wide, .parameter_bytes = 24},
    .parameters = corners_parameters,
    .longest_loop = {"large_arrays.glift", 20},
};

}  // namespace large_arrays

