// Made by gliftc from predicates.glift. Changes are lost when it is made again.
#include "predicates.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace predicates {

using namespace glift::types;

// ----------------------------------------------------------------------------------------------------
// predicates.glift:10: shift

namespace {
struct shift_direct_parameters {
    uint x_extent;
    uint by;
};
static_assert(offsetof(shift_direct_parameters, x_extent) == 0);
static_assert(offsetof(shift_direct_parameters, by) == 4);

// predicates.glift:10: runs one workgroup of shift.
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
    bool test[64];
    uint next[64];
    uint chosen[64];
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
        next[local_index] = 0u;
        if (from_value_inside) {
            next[local_index] = from_data[i_2];
        }
        // predicates.glift:14
        test[local_index] = i_2 % 2u == 0u;
        const uint from_address = test[local_index] ? i_2 : by;
        const bool from_value_inside_2 = from_address < x_extent;
        chosen[local_index] = 0u;
        if (from_value_inside_2) {
            chosen[local_index] = from_data[from_address];
        }
        // predicates.glift:15
        uint x_value = 0u;
        if (in_range[local_index]) {
            x_value = x_data[address_2[local_index]];
        }
        part_2[local_index] = x_value + next[local_index];
    }
    // predicates.glift:16
    // barrier: ends a loop over the invocations
    for (uint local_index = 0; local_index < 64; ++local_index) {
        // predicates.glift:17
        uint x_value = 0u;
        if (in_range[local_index]) {
            x_value = x_data[address_2[local_index]];
        }
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

// predicates.glift:10: runs one workgroup of shift.
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
    uint x_address[64];
    uint to_address[64];
    bool test[64];
    uint next[64];
    uint chosen[64];
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
        next[local_index] = 0u;
        if (from_value_inside) {
            next[local_index] = from_data[from_virtual];
        }
        // predicates.glift:14
        test[local_index] = i_2 % 2u == 0u;
        const uint from_address = test[local_index] ? i_2 : by;
        const uint from_virtual_2 = from_origin + from_address;
        const bool from_value_inside_2 = from_address < from_size;
        chosen[local_index] = 0u;
        if (from_value_inside_2) {
            chosen[local_index] = from_data[from_virtual_2];
        }
        // predicates.glift:15
        uint x_value = 0u;
        if (in_range[local_index]) {
            x_value = x_data[x_address[local_index]];
        }
        part_2[local_index] = x_value + next[local_index];
    }
    // predicates.glift:16
    // barrier: ends a loop over the invocations
    for (uint local_index = 0; local_index < 64; ++local_index) {
        // predicates.glift:17
        uint x_value = 0u;
        if (in_range[local_index]) {
            x_value = x_data[x_address[local_index]];
        }
        if (in_range[local_index]) {
            to_data[to_address[local_index]] = part_2[63u - local_index] + chosen[local_index]
                + (test[local_index] ? chosen[local_index] : 7u) + next[local_index] + x_value;
        }
    }
}

static void shift_general(const glift::HostCall& call) {
    glift::host::for_each_group(call.size, uint3(64, 1, 1), [&](uint3 group_id, uint3 group_count) {
        shift_general_group(call, group_id, group_count);
    });
}

struct shift_wide_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint x_origin;
    uint to_origin;
    uint by;
    std::uint64_t from_data_address;
    std::uint64_t x_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(shift_wide_parameters, size) == 0);
static_assert(offsetof(shift_wide_parameters, from_origin) == 4);
static_assert(offsetof(shift_wide_parameters, from_size) == 8);
static_assert(offsetof(shift_wide_parameters, x_origin) == 12);
static_assert(offsetof(shift_wide_parameters, to_origin) == 16);
static_assert(offsetof(shift_wide_parameters, by) == 20);
static_assert(offsetof(shift_wide_parameters, from_data_address) == 24);
static_assert(offsetof(shift_wide_parameters, x_data_address) == 32);
static_assert(offsetof(shift_wide_parameters, to_data_address) == 40);

// predicates.glift:10: runs one workgroup of shift.
GLIFT_HOST_KERNEL
static void shift_wide_group(const glift::HostCall& call, [[maybe_unused]] uint3 group_id,
    [[maybe_unused]] uint3 group_count) {
    [[maybe_unused]] constexpr uint group_size = 64;
    [[maybe_unused]] const uint group_index = (group_id.z * group_count.y + group_id.y) * group_count.x + group_id.x;
    [[maybe_unused]] const uint group_total = group_count.x * group_count.y * group_count.z;
    const auto& parameters = *static_cast<const shift_wide_parameters*>(call.parameters);
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
    std::uint64_t x_at[64];
    std::uint64_t to_at[64];
    bool test[64];
    uint next[64];
    uint chosen[64];
    for (uint local_index = 0; local_index < 64; ++local_index) {
        const uint3 local_id{local_index % 64, local_index / 64 % 1, local_index / 64};
        const uint3 global_id = group_id * uint3(64, 1, 1) + local_id;
        // predicates.glift:10
        const uint address_2 = global_id.y * (group_count.x * 64u) + global_id.x;
        in_range[local_index] = address_2 < size;
        // predicates.glift:15
        const uint x_address = x_origin + address_2;
        // predicates.glift:10
        x_at[local_index] = std::uint64_t(x_address);
        // predicates.glift:17
        const uint to_address = to_origin + address_2;
        // predicates.glift:10
        to_at[local_index] = std::uint64_t(to_address);
        // predicates.glift:12
        const uint i_2 = address_2 + by;
        // predicates.glift:13
        const uint from_virtual = from_origin + i_2;
        const bool from_value_inside = i_2 < from_size;
        const std::uint64_t from_value_at = std::uint64_t(from_virtual);
        next[local_index] = 0u;
        if (from_value_inside) {
            next[local_index] = from_data[from_value_at];
        }
        // predicates.glift:14
        test[local_index] = i_2 % 2u == 0u;
        const uint from_address = test[local_index] ? i_2 : by;
        const uint from_virtual_2 = from_origin + from_address;
        const bool from_value_inside_2 = from_address < from_size;
        const std::uint64_t from_value_at_2 = std::uint64_t(from_virtual_2);
        chosen[local_index] = 0u;
        if (from_value_inside_2) {
            chosen[local_index] = from_data[from_value_at_2];
        }
        // predicates.glift:15
        uint x_value = 0u;
        if (in_range[local_index]) {
            x_value = x_data[x_at[local_index]];
        }
        part_2[local_index] = x_value + next[local_index];
    }
    // predicates.glift:16
    // barrier: ends a loop over the invocations
    for (uint local_index = 0; local_index < 64; ++local_index) {
        // predicates.glift:17
        uint x_value = 0u;
        if (in_range[local_index]) {
            x_value = x_data[x_at[local_index]];
        }
        if (in_range[local_index]) {
            to_data[to_at[local_index]] = part_2[63u - local_index] + chosen[local_index]
                + (test[local_index] ? chosen[local_index] : 7u) + next[local_index] + x_value;
        }
    }
}

static void shift_wide(const glift::HostCall& call) {
    glift::host::for_each_group(call.size, uint3(64, 1, 1), [&](uint3 group_id, uint3 group_count) {
        shift_wide_group(call, group_id, group_count);
    });
}

const glift::Binding shift_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 24,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::range},
    {.name = "x.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 32,
        .element_bytes = sizeof(uint), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 40,
        .element_bytes = sizeof(uint), .parameter = 2, .reach = glift::Reach::element},
};
constexpr glift::Parameter shift_parameters[] = {
    {"x_extent", 0, sizeof(shift_direct_parameters::x_extent)},
    {"by", 4, sizeof(shift_direct_parameters::by)},
};
}  // namespace

extern const glift::Kernel shift_kernel;
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
    .wide = {.host = &shift_wide, .parameter_bytes = 48},
    .parameters = shift_parameters,
    .shared_bytes = 256,
};

// ----------------------------------------------------------------------------------------------------
// predicates.glift:21: pick

namespace {
struct pick_direct_parameters {
    uint x_extent;
};
static_assert(offsetof(pick_direct_parameters, x_extent) == 0);

// predicates.glift:21: runs one workgroup of pick.
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
    // barrier: ends a loop over the invocations
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

// predicates.glift:21: runs one workgroup of pick.
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
                x_value = x_data[x_address];
            }
            result_2 = x_value;
        } else {
            result_2 = 4u;
        }
        second[local_index] = result_2;
    }
    // predicates.glift:25
    // barrier: ends a loop over the invocations
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

struct pick_wide_parameters {
    uint size;
    uint x_origin;
    uint to_origin;
    std::uint64_t x_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(pick_wide_parameters, size) == 0);
static_assert(offsetof(pick_wide_parameters, x_origin) == 4);
static_assert(offsetof(pick_wide_parameters, to_origin) == 8);
static_assert(offsetof(pick_wide_parameters, x_data_address) == 16);
static_assert(offsetof(pick_wide_parameters, to_data_address) == 24);

// predicates.glift:21: runs one workgroup of pick.
GLIFT_HOST_KERNEL
static void pick_wide_group(const glift::HostCall& call, [[maybe_unused]] uint3 group_id,
    [[maybe_unused]] uint3 group_count) {
    [[maybe_unused]] constexpr uint group_size = 64;
    [[maybe_unused]] const uint group_index = (group_id.z * group_count.y + group_id.y) * group_count.x + group_id.x;
    [[maybe_unused]] const uint group_total = group_count.x * group_count.y * group_count.z;
    const auto& parameters = *static_cast<const pick_wide_parameters*>(call.parameters);
    const uint size = parameters.size;
    const uint x_origin = parameters.x_origin;
    const uint to_origin = parameters.to_origin;
    const uint* x_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    bool in_range[64];
    uint first_2[64];
    uint second[64];
    std::uint64_t to_at[64];
    for (uint local_index = 0; local_index < 64; ++local_index) {
        const uint3 local_id{local_index % 64, local_index / 64 % 1, local_index / 64};
        const uint3 global_id = group_id * uint3(64, 1, 1) + local_id;
        // predicates.glift:21
        const uint address_2 = global_id.y * (group_count.x * 64u) + global_id.x;
        in_range[local_index] = address_2 < size;
        // predicates.glift:23
        const uint x_address = x_origin + address_2;
        // predicates.glift:21
        const std::uint64_t x_at = std::uint64_t(x_address);
        // predicates.glift:26
        const uint to_address = to_origin + address_2;
        // predicates.glift:21
        to_at[local_index] = std::uint64_t(to_address);
        // predicates.glift:22
        const bool inside_2 = local_index < 32u;
        // predicates.glift:23
        uint result{};
        if (inside_2) {
            uint x_value = 0u;
            if (in_range[local_index]) {
                x_value = x_data[x_at];
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
                x_value = x_data[x_at];
            }
            result_2 = x_value;
        } else {
            result_2 = 4u;
        }
        second[local_index] = result_2;
    }
    // predicates.glift:25
    // barrier: ends a loop over the invocations
    for (uint local_index = 0; local_index < 64; ++local_index) {
        // predicates.glift:26
        if (in_range[local_index]) {
            to_data[to_at[local_index]] = first_2[local_index] + second[local_index];
        }
    }
}

static void pick_wide(const glift::HostCall& call) {
    glift::host::for_each_group(call.size, uint3(64, 1, 1), [&](uint3 group_id, uint3 group_count) {
        pick_wide_group(call, group_id, group_count);
    });
}

const glift::Binding pick_bindings[] = {
    {.name = "x.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .element_bytes = sizeof(uint), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter pick_parameters[] = {
    {"x_extent", 0, sizeof(pick_direct_parameters::x_extent)},
};
}  // namespace

extern const glift::Kernel pick_kernel;
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
    .wide = {.host = &pick_wide, .parameter_bytes = 32},
    .parameters = pick_parameters,
};

}  // namespace predicates

