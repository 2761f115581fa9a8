// Made by gliftc from fours.glift. Changes are lost when it is made again.
#include "fours.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace fours {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// fours.glift:8: sum_fours

namespace {
struct sum_fours_direct_parameters {
    uint a_extent;
    uint shift;
};
static_assert(offsetof(sum_fours_direct_parameters, a_extent) == 0);
static_assert(offsetof(sum_fours_direct_parameters, shift) == 4);

// fours.glift:8: runs kernel sum_fours for the given rows.
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

// fours.glift:8: runs kernel sum_fours for the given rows.
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

struct sum_fours_wide_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint to_origin;
    uint to_size;
    uint shift;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(sum_fours_wide_parameters, size) == 0);
static_assert(offsetof(sum_fours_wide_parameters, from_origin) == 4);
static_assert(offsetof(sum_fours_wide_parameters, from_size) == 8);
static_assert(offsetof(sum_fours_wide_parameters, to_origin) == 12);
static_assert(offsetof(sum_fours_wide_parameters, to_size) == 16);
static_assert(offsetof(sum_fours_wide_parameters, shift) == 20);
static_assert(offsetof(sum_fours_wide_parameters, from_data_address) == 24);
static_assert(offsetof(sum_fours_wide_parameters, to_data_address) == 32);

// fours.glift:8: runs kernel sum_fours for the given rows.
GLIFT_HOST_KERNEL
static void sum_fours_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const sum_fours_wide_parameters*>(call.parameters);
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
            const std::uint64_t from0_value_at = std::uint64_t(from_virtual);
            const uint from0_value = from_data[from0_value_inside ? from0_value_at : std::uint64_t{0u}];
            from_items[0u] = from0_value_inside ? from0_value : 0u;
            const uint from1_address = address + 1u;
            const uint from1_virtual = from_origin + from1_address;
            const bool from1_value_inside = from1_address < from_size;
            const std::uint64_t from1_value_at = std::uint64_t(from1_virtual);
            const uint from1_value = from_data[from1_value_inside ? from1_value_at : std::uint64_t{0u}];
            from_items[1u] = from1_value_inside ? from1_value : 0u;
            const uint from2_address = address + 2u;
            const uint from2_virtual = from_origin + from2_address;
            const bool from2_value_inside = from2_address < from_size;
            const std::uint64_t from2_value_at = std::uint64_t(from2_virtual);
            const uint from2_value = from_data[from2_value_inside ? from2_value_at : std::uint64_t{0u}];
            from_items[2u] = from2_value_inside ? from2_value : 0u;
            const uint from3_address = address + 3u;
            const uint from3_virtual = from_origin + from3_address;
            const bool from3_value_inside = from3_address < from_size;
            const std::uint64_t from3_value_at = std::uint64_t(from3_virtual);
            const uint from3_value = from_data[from3_value_inside ? from3_value_at : std::uint64_t{0u}];
            from_items[3u] = from3_value_inside ? from3_value : 0u;
            const glift::array<uint, 4>& whole = from_items;
            // fours.glift:10
            const uint from_first = address + shift;
            const uint from_virtual_2 = from_origin + from_first;
            glift::array<uint, 4> from_items_2 = glift::array<uint, 4>{};
            const bool from0_value_inside_2 = from_first < from_size;
            const std::uint64_t from0_value_at_2 = std::uint64_t(from_virtual_2);
            const uint from0_value_2 = from_data[from0_value_inside_2 ? from0_value_at_2 : std::uint64_t{0u}];
            from_items_2[0u] = from0_value_inside_2 ? from0_value_2 : 0u;
            const uint from1_address_2 = from_first + 1u;
            const uint from1_virtual_2 = from_origin + from1_address_2;
            const bool from1_value_inside_2 = from1_address_2 < from_size;
            const std::uint64_t from1_value_at_2 = std::uint64_t(from1_virtual_2);
            const uint from1_value_2 = from_data[from1_value_inside_2 ? from1_value_at_2 : std::uint64_t{0u}];
            from_items_2[1u] = from1_value_inside_2 ? from1_value_2 : 0u;
            const uint from2_address_2 = from_first + 2u;
            const uint from2_virtual_2 = from_origin + from2_address_2;
            const bool from2_value_inside_2 = from2_address_2 < from_size;
            const std::uint64_t from2_value_at_2 = std::uint64_t(from2_virtual_2);
            const uint from2_value_2 = from_data[from2_value_inside_2 ? from2_value_at_2 : std::uint64_t{0u}];
            from_items_2[2u] = from2_value_inside_2 ? from2_value_2 : 0u;
            const uint from3_address_2 = from_first + 3u;
            const uint from3_virtual_2 = from_origin + from3_address_2;
            const bool from3_value_inside_2 = from3_address_2 < from_size;
            const std::uint64_t from3_value_at_2 = std::uint64_t(from3_virtual_2);
            const uint from3_value_2 = from_data[from3_value_inside_2 ? from3_value_at_2 : std::uint64_t{0u}];
            from_items_2[3u] = from3_value_inside_2 ? from3_value_2 : 0u;
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
            if (address < to_size) {
                to_data[std::uint64_t(to_virtual)] = to_items[0u];
            }
            const uint to_virtual_2 = to_origin + from1_address;
            if (from1_address < to_size) {
                to_data[std::uint64_t(to_virtual_2)] = to_items[1u];
            }
            const uint to_virtual_3 = to_origin + from2_address;
            if (from2_address < to_size) {
                to_data[std::uint64_t(to_virtual_3)] = to_items[2u];
            }
            const uint to_virtual_4 = to_origin + from3_address;
            if (from3_address < to_size) {
                to_data[std::uint64_t(to_virtual_4)] = to_items[3u];
            }
        }
    }
}

static void sum_fours_wide(const glift::HostCall& call) {
    glift::host::for_strides(call.size[0], 4, [&](const glift::host::Rows& rows) { sum_fours_wide_rows(call, rows); });
}

const glift::Binding sum_fours_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::range},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 32,
        .element_bytes = sizeof(uint), .parameter = 2, .reach = glift::Reach::range},
};
constexpr glift::Parameter sum_fours_parameters[] = {
    {"a_extent", 0, sizeof(sum_fours_direct_parameters::a_extent)},
    {"shift", 4, sizeof(sum_fours_direct_parameters::shift)},
};
}  // namespace

extern const glift::Kernel sum_fours_kernel;
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
    .wide = {.host = &sum_fours_wide, .parameter_bytes = 40},
    .parameters = sum_fours_parameters,
    .items = {4, 1, 1},
    .longest_loop = {"fours.glift", 12},
};

}  // namespace fours

