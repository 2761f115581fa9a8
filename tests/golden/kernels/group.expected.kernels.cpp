// Made by gliftc from group.glift. Changes are lost when it is made again.
#include "group.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace group_ {

using namespace glift::types;

// group.glift:8: block_sums

namespace {
struct block_sums_general_parameters {
    uint size;
    uint value_origin;
    uint sums_origin;
    uint sums_size;
    std::uint64_t value_data_address;
    std::uint64_t sums_data_address;
};
static_assert(sizeof(block_sums_general_parameters) == 32);

// group.glift:8: runs one workgroup of block_sums.
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
    // barrier: ends a loop over the invocations
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
        // barrier: ends a loop over the invocations
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
    {.name = "value.data", .address_offset = 16, .element_bytes = sizeof(uint), .reach = glift::Reach::element},
    {.name = "sums.data", .access = glift::Access::write, .address_offset = 24, .element_bytes = sizeof(uint),
        .parameter = 1, .reach = glift::Reach::range, .update = glift::Update::store},
};
constexpr glift::Parameter block_sums_parameters[] = {{"value_extent", 0, 4}};
}  // namespace

extern const glift::Kernel block_sums_kernel;
const glift::Kernel block_sums_kernel = {
    .name = "block_sums",
    .file = "group.glift",
    .line = 8,
    .rank = 1,
    .group = {64, 1, 1},
    .loop_rounds = UINT64_MAX,
    .bindings = block_sums_bindings,
    .direct = {.parameter_bytes = 4, .push_constants = true},
    .general = {.host = &block_sums_general, .parameter_bytes = 32, .uniform_buffer = true},
    .parameters = block_sums_parameters,
    .declares_group = true,
    .reports = true,
    .shared_bytes = 256,
    .longest_loop = {"group.glift", 14},
};

}  // namespace group_

