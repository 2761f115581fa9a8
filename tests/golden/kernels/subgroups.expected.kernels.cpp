// Made by gliftc from subgroups.glift. Changes are lost when it is made again.
#include "subgroups.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace subgroups {

using namespace glift::types;

namespace {

// subgroups.glift:15: better
inline Best better(Best a, Best b) {
    // subgroups.glift:16
    if (b.value < a.value) {
        // subgroups.glift:17
        return b;
    }
    // subgroups.glift:19
    return a;
}

}  // namespace

// ----------------------------------------------------------------------------------------------------
// subgroups.glift:22: best_of_subgroup

namespace {
struct best_of_subgroup_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(best_of_subgroup_direct_parameters, from_extent) == 0);

// subgroups.glift:22: runs one workgroup of best_of_subgroup.
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
        // subgroups.glift:22
        const uint address_2 = global_id.y * (group_count.x * 64u) + global_id.x;
        const bool in_range = address_2 < from_extent;
        // subgroups.glift:23
        const uint lane_2 = 0u;
        // subgroups.glift:24
        uint from_value = 0u;
        if (in_range) {
            from_value = from_data[address_2];
        }
        Best best = Best{float(from_value), uint2(lane_2, local_index), glift::array<int, 2>{{1, 2}}};
        // subgroups.glift:25
        uint stride = 1u / 2u;
        // subgroups.glift:26
        while (stride > 0u) {
            // subgroups.glift:27
            best = better(best, glift::subgroupShuffleXor(best, stride));
            // subgroups.glift:28
            stride = stride / 2u;
        }
        // subgroups.glift:30
        const uint2 first_2 = glift::subgroupBroadcast(best.where, 0u);
        // subgroups.glift:31
        const uint4 mask = glift::subgroupBallot(lane_2 == first_2.x);
        // subgroups.glift:32
        if (in_range) {
            to_data[address_2] = first_2.x + mask.x + 64u + glift::subgroupShuffle(from_value, lane_2 + 1u);
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

// subgroups.glift:22: runs one workgroup of best_of_subgroup.
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
        // subgroups.glift:22
        const uint address_2 = global_id.y * (group_count.x * 64u) + global_id.x;
        const bool in_range = address_2 < size;
        // subgroups.glift:24
        const uint from_address = from_origin + address_2;
        // subgroups.glift:32
        const uint to_address = to_origin + address_2;
        // subgroups.glift:23
        const uint lane_2 = 0u;
        // subgroups.glift:24
        uint from_value = 0u;
        if (in_range) {
            from_value = from_data[from_address];
        }
        Best best = Best{float(from_value), uint2(lane_2, local_index), glift::array<int, 2>{{1, 2}}};
        // subgroups.glift:25
        uint stride = 1u / 2u;
        // subgroups.glift:26
        while (stride > 0u) {
            // subgroups.glift:27
            best = better(best, glift::subgroupShuffleXor(best, stride));
            // subgroups.glift:28
            stride = stride / 2u;
        }
        // subgroups.glift:30
        const uint2 first_2 = glift::subgroupBroadcast(best.where, 0u);
        // subgroups.glift:31
        const uint4 mask = glift::subgroupBallot(lane_2 == first_2.x);
        // subgroups.glift:32
        if (in_range) {
            to_data[to_address] = first_2.x + mask.x + 64u + glift::subgroupShuffle(from_value, lane_2 + 1u);
        }
    }
}

static void best_of_subgroup_general(const glift::HostCall& call) {
    glift::host::for_each_group(call.size, uint3(64, 1, 1), [&](uint3 group_id, uint3 group_count) {
        best_of_subgroup_general_group(call, group_id, group_count);
    });
}

struct best_of_subgroup_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(best_of_subgroup_wide_parameters, size) == 0);
static_assert(offsetof(best_of_subgroup_wide_parameters, from_origin) == 4);
static_assert(offsetof(best_of_subgroup_wide_parameters, to_origin) == 8);
static_assert(offsetof(best_of_subgroup_wide_parameters, from_data_address) == 16);
static_assert(offsetof(best_of_subgroup_wide_parameters, to_data_address) == 24);

// subgroups.glift:22: runs one workgroup of best_of_subgroup.
GLIFT_HOST_KERNEL
static void best_of_subgroup_wide_group(const glift::HostCall& call, [[maybe_unused]] uint3 group_id,
    [[maybe_unused]] uint3 group_count) {
    [[maybe_unused]] constexpr uint group_size = 64;
    [[maybe_unused]] const uint group_index = (group_id.z * group_count.y + group_id.y) * group_count.x + group_id.x;
    [[maybe_unused]] const uint group_total = group_count.x * group_count.y * group_count.z;
    const auto& parameters = *static_cast<const best_of_subgroup_wide_parameters*>(call.parameters);
    const uint size = parameters.size;
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    for (uint local_index = 0; local_index < 64; ++local_index) {
        const uint3 local_id{local_index % 64, local_index / 64 % 1, local_index / 64};
        const uint3 global_id = group_id * uint3(64, 1, 1) + local_id;
        // subgroups.glift:22
        const uint address_2 = global_id.y * (group_count.x * 64u) + global_id.x;
        const bool in_range = address_2 < size;
        // subgroups.glift:24
        const uint from_address = from_origin + address_2;
        // subgroups.glift:22
        const std::uint64_t from_at = std::uint64_t(from_address);
        // subgroups.glift:32
        const uint to_address = to_origin + address_2;
        // subgroups.glift:22
        const std::uint64_t to_at = std::uint64_t(to_address);
        // subgroups.glift:23
        const uint lane_2 = 0u;
        // subgroups.glift:24
        uint from_value = 0u;
        if (in_range) {
            from_value = from_data[from_at];
        }
        Best best = Best{float(from_value), uint2(lane_2, local_index), glift::array<int, 2>{{1, 2}}};
        // subgroups.glift:25
        uint stride = 1u / 2u;
        // subgroups.glift:26
        while (stride > 0u) {
            // subgroups.glift:27
            best = better(best, glift::subgroupShuffleXor(best, stride));
            // subgroups.glift:28
            stride = stride / 2u;
        }
        // subgroups.glift:30
        const uint2 first_2 = glift::subgroupBroadcast(best.where, 0u);
        // subgroups.glift:31
        const uint4 mask = glift::subgroupBallot(lane_2 == first_2.x);
        // subgroups.glift:32
        if (in_range) {
            to_data[to_at] = first_2.x + mask.x + 64u + glift::subgroupShuffle(from_value, lane_2 + 1u);
        }
    }
}

static void best_of_subgroup_wide(const glift::HostCall& call) {
    glift::host::for_each_group(call.size, uint3(64, 1, 1), [&](uint3 group_id, uint3 group_count) {
        best_of_subgroup_wide_group(call, group_id, group_count);
    });
}

const glift::Binding best_of_subgroup_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .element_bytes = sizeof(uint), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter best_of_subgroup_parameters[] = {
    {"from_extent", 0, sizeof(best_of_subgroup_direct_parameters::from_extent)},
};
}  // namespace

extern const glift::Kernel best_of_subgroup_kernel;
const glift::Kernel best_of_subgroup_kernel = {
    .name = "best_of_subgroup",
    .file = "subgroups.glift",
    .line = 22,
    .rank = 1,
    .group = {64, 1, 1},
    .loop_rounds = UINT64_MAX,
    .bindings = best_of_subgroup_bindings,
    .direct = {.host = &best_of_subgroup_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &best_of_subgroup_general, .parameter_bytes = 12},
    .wide = {.host = &best_of_subgroup_wide, .parameter_bytes = 32},
    .parameters = best_of_subgroup_parameters,
    .reports = true,
    .longest_loop = {"subgroups.glift", 26},
};

// ----------------------------------------------------------------------------------------------------
// subgroups.glift:36: turn_subgroups

namespace {
struct turn_subgroups_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(turn_subgroups_direct_parameters, from_extent) == 0);

// subgroups.glift:36: runs one workgroup of turn_subgroups.
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
        // subgroups.glift:36
        const uint address_2 = global_id.y * (group_count.x * 64u) + global_id.x;
        const bool in_range = address_2 < from_extent;
        // subgroups.glift:38
        uint from_value = 0u;
        if (in_range) {
            from_value = from_data[address_2];
        }
        values[local_index] = from_value;
        // subgroups.glift:40
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

// subgroups.glift:36: runs one workgroup of turn_subgroups.
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
        // subgroups.glift:36
        const uint address_2 = global_id.y * (group_count.x * 64u) + global_id.x;
        const bool in_range = address_2 < size;
        // subgroups.glift:38
        const uint from_address = from_origin + address_2;
        // subgroups.glift:40
        const uint to_address = to_origin + address_2;
        // subgroups.glift:38
        uint from_value = 0u;
        if (in_range) {
            from_value = from_data[from_address];
        }
        values[local_index] = from_value;
        // subgroups.glift:40
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

struct turn_subgroups_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(turn_subgroups_wide_parameters, size) == 0);
static_assert(offsetof(turn_subgroups_wide_parameters, from_origin) == 4);
static_assert(offsetof(turn_subgroups_wide_parameters, to_origin) == 8);
static_assert(offsetof(turn_subgroups_wide_parameters, from_data_address) == 16);
static_assert(offsetof(turn_subgroups_wide_parameters, to_data_address) == 24);

// subgroups.glift:36: runs one workgroup of turn_subgroups.
GLIFT_HOST_KERNEL
static void turn_subgroups_wide_group(const glift::HostCall& call, [[maybe_unused]] uint3 group_id,
    [[maybe_unused]] uint3 group_count) {
    [[maybe_unused]] constexpr uint group_size = 64;
    [[maybe_unused]] const uint group_index = (group_id.z * group_count.y + group_id.y) * group_count.x + group_id.x;
    [[maybe_unused]] const uint group_total = group_count.x * group_count.y * group_count.z;
    const auto& parameters = *static_cast<const turn_subgroups_wide_parameters*>(call.parameters);
    const uint size = parameters.size;
    const uint from_origin = parameters.from_origin;
    const uint to_origin = parameters.to_origin;
    const uint* from_data = glift::host::elements<const uint>(call.memories[0]);
    uint* to_data = glift::host::elements<uint>(call.memories[1]);
    glift::array<uint, 64> values;
    for (uint local_index = 0; local_index < 64; ++local_index) {
        const uint3 local_id{local_index % 64, local_index / 64 % 1, local_index / 64};
        const uint3 global_id = group_id * uint3(64, 1, 1) + local_id;
        // subgroups.glift:36
        const uint address_2 = global_id.y * (group_count.x * 64u) + global_id.x;
        const bool in_range = address_2 < size;
        // subgroups.glift:38
        const uint from_address = from_origin + address_2;
        // subgroups.glift:36
        const std::uint64_t from_at = std::uint64_t(from_address);
        // subgroups.glift:40
        const uint to_address = to_origin + address_2;
        // subgroups.glift:36
        const std::uint64_t to_at = std::uint64_t(to_address);
        // subgroups.glift:38
        uint from_value = 0u;
        if (in_range) {
            from_value = from_data[from_at];
        }
        values[local_index] = from_value;
        // subgroups.glift:40
        if (in_range) {
            to_data[to_at] = values[local_index + 1u - 1u - 2u * 0u];
        }
    }
}

static void turn_subgroups_wide(const glift::HostCall& call) {
    glift::host::for_each_group(call.size, uint3(64, 1, 1), [&](uint3 group_id, uint3 group_count) {
        turn_subgroups_wide_group(call, group_id, group_count);
    });
}

const glift::Binding turn_subgroups_bindings[] = {
    {.name = "from.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read, .address_offset = 16,
        .element_bytes = sizeof(uint), .reach = glift::Reach::element},
    {.name = "to.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .element_bytes = sizeof(uint), .parameter = 1, .reach = glift::Reach::element},
};
constexpr glift::Parameter turn_subgroups_parameters[] = {
    {"from_extent", 0, sizeof(turn_subgroups_direct_parameters::from_extent)},
};
}  // namespace

extern const glift::Kernel turn_subgroups_kernel;
const glift::Kernel turn_subgroups_kernel = {
    .name = "turn_subgroups",
    .file = "subgroups.glift",
    .line = 36,
    .rank = 1,
    .group = {64, 1, 1},
    .loop_rounds = 0,
    .bindings = turn_subgroups_bindings,
    .direct = {.host = &turn_subgroups_direct, .parameter_bytes = 4, .push_constants = true},
    .general = {.host = &turn_subgroups_general, .parameter_bytes = 12},
    .wide = {.host = &turn_subgroups_wide, .parameter_bytes = 32},
    .parameters = turn_subgroups_parameters,
    .shared_bytes = 256,
};

}  // namespace subgroups

