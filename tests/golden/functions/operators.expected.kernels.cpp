// Made by gliftc from operators.glift. Changes are lost when it is made again.
#include "operators.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace operators {

using namespace glift::types;

namespace {

// operators.glift:15: combine
inline uint combine([[maybe_unused]] Max op, uint a, uint b) {
    return glift::max(a, b);
}

// operators.glift:25: repeated<Max>
inline uint repeated(Max op, uint a, uint limit) {
    // operators.glift:26
    uint x = 1u;
    // operators.glift:27
    uint rounds = 0u;
    // operators.glift:28
    while (rounds < limit) {
        // operators.glift:29
        x = combine(op, x, a);
        // operators.glift:30
        rounds += 1u;
    }
    // operators.glift:32
    return x;
}

// operators.glift:22: combine
inline uint combine_2(Affine op, uint a, uint b) {
    return glift::remainder(combine(op.inner, a * b + a, b), op.modulus);
}

// operators.glift:25: repeated<Affine>
inline uint repeated_2(Affine op, uint a, uint limit) {
    // operators.glift:26
    uint x = 1u;
    // operators.glift:27
    uint rounds = 0u;
    // operators.glift:28
    while (rounds < limit) {
        // operators.glift:29
        x = combine_2(op, x, a);
        // operators.glift:30
        rounds += 1u;
    }
    // operators.glift:32
    return x;
}

}  // namespace

// ----------------------------------------------------------------------------------------------------
// operators.glift:35: use_both

namespace {
struct use_both_direct_parameters {
    uint a_extent;
    uint affine_modulus;
};
static_assert(offsetof(use_both_direct_parameters, a_extent) == 0);
static_assert(offsetof(use_both_direct_parameters, affine_modulus) == 4);

// operators.glift:35: runs kernel use_both for the given rows.
GLIFT_HOST_KERNEL
static void use_both_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const use_both_direct_parameters*>(call.parameters);
    const uint affine_modulus = parameters.affine_modulus;
    uint* a_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            uint* a_data_row = glift::host::row_pointer(a_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // operators.glift:36
                const uint a_value = a_data_row[i];
                a_data_row[i] = repeated(Max{}, a_value, 4u) + repeated_2(Affine{affine_modulus, Max{}}, a_value, 5u);
            }
        }
    }
}

static void use_both_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { use_both_direct_rows(call, rows); });
}

struct use_both_general_parameters {
    uint size;
    uint a_origin;
    uint affine_modulus;
};
static_assert(offsetof(use_both_general_parameters, size) == 0);
static_assert(offsetof(use_both_general_parameters, a_origin) == 4);
static_assert(offsetof(use_both_general_parameters, affine_modulus) == 8);

// operators.glift:35: runs kernel use_both for the given rows.
GLIFT_HOST_KERNEL
static void use_both_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const use_both_general_parameters*>(call.parameters);
    const uint a_origin = parameters.a_origin;
    const uint affine_modulus = parameters.affine_modulus;
    uint* a_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // operators.glift:36
            const uint a_address = a_origin + address;
            uint* a_data_row = glift::host::row_pointer(a_data + a_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                // operators.glift:36
                const uint a_value = a_data_row[i];
                a_data_row[i] = repeated(Max{}, a_value, 4u) + repeated_2(Affine{affine_modulus, Max{}}, a_value, 5u);
            }
        }
    }
}

static void use_both_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { use_both_general_rows(call, rows); });
}

struct use_both_wide_parameters {
    uint size;
    uint a_origin;
    uint affine_modulus;
    std::uint64_t a_data_address;
};
static_assert(offsetof(use_both_wide_parameters, size) == 0);
static_assert(offsetof(use_both_wide_parameters, a_origin) == 4);
static_assert(offsetof(use_both_wide_parameters, affine_modulus) == 8);
static_assert(offsetof(use_both_wide_parameters, a_data_address) == 16);

// operators.glift:35: runs kernel use_both for the given rows.
GLIFT_HOST_KERNEL
static void use_both_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const use_both_wide_parameters*>(call.parameters);
    const uint a_origin = parameters.a_origin;
    const uint affine_modulus = parameters.affine_modulus;
    uint* a_data = glift::host::elements<uint>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // operators.glift:36
            const uint a_address = a_origin + address;
            // operators.glift:35
            const std::uint64_t a_at = std::uint64_t(a_address);
            // operators.glift:36
            const uint a_value = a_data[a_at];
            a_data[a_at] = repeated(Max{}, a_value, 4u) + repeated_2(Affine{affine_modulus, Max{}}, a_value, 5u);
        }
    }
}

static void use_both_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { use_both_wide_rows(call, rows); });
}

const glift::Binding use_both_bindings[] = {
    {.name = "a.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read_write, .address_offset = 16,
        .element_bytes = sizeof(uint)},
};
constexpr glift::Parameter use_both_parameters[] = {
    {"a_extent", 0, sizeof(use_both_direct_parameters::a_extent)},
    {"affine_modulus", 4, sizeof(use_both_direct_parameters::affine_modulus)},
};
}  // namespace

extern const glift::Kernel use_both_kernel;
const glift::Kernel use_both_kernel = {
    .name = "use_both",
    .file = "operators.glift",
    .line = 35,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = UINT64_MAX,
    .bindings = use_both_bindings,
    .direct = {.host = &use_both_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &use_both_general, .parameter_bytes = 12},
    .wide = {.host = &use_both_wide, .parameter_bytes = 24},
    .parameters = use_both_parameters,
    .reports = true,
    .longest_loop = {"operators.glift", 28},
};

}  // namespace operators

