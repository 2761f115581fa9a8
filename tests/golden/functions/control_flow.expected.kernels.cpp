// Made by gliftc from control_flow.glift. Changes are lost when it is made again.
#include "control_flow.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace control_flow {

using namespace glift::types;

namespace {

// control_flow.glift:18: halves<3>
inline float halves(float x) {
    // control_flow.glift:19
    float y = x;
    // control_flow.glift:20
    for (uint i = 0u; i < 3u; ++i) {
        y *= 0.5f;
    }
    // control_flow.glift:21
    return y;
}

// control_flow.glift:29: collatz
inline uint collatz(uint start) {
    // control_flow.glift:30
    uint n = start;
    // control_flow.glift:31
    uint steps = 0u;
    // control_flow.glift:32
    while (n > 1u) {
        // control_flow.glift:33
        if (steps == 100u) {
            break;
        }
        // control_flow.glift:34
        if (n % 2u == 0u) {
            n = n / 2u;
        } else {
            n = 3u * n + 1u;
        }
        // control_flow.glift:35
        steps += 1u;
    }
    // control_flow.glift:37
    return steps;
}

}  // namespace

// ----------------------------------------------------------------------------------------------------
// control_flow.glift:40: control_flow

namespace {
struct control_flow_direct_parameters {
    uint a_extent;
    glift::Bool mode_value_0;
};
static_assert(offsetof(control_flow_direct_parameters, a_extent) == 0);
static_assert(offsetof(control_flow_direct_parameters, mode_value_0) == 4);

// control_flow.glift:40: runs kernel control_flow for the given rows.
GLIFT_HOST_KERNEL
static void control_flow_direct_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const control_flow_direct_parameters*>(call.parameters);
    const bool mode_value_0 = parameters.mode_value_0;
    float* f_data = glift::host::elements<float>(call.memories[0]);
    uint* n_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            float* f_data_row = glift::host::row_pointer(f_data + address);
            uint* n_data_row = glift::host::row_pointer(n_data + address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint address = row.begin + static_cast<uint>(i);
                // control_flow.glift:41
                const Interval i_2 = Interval{1.0f, float(address)};
                // control_flow.glift:42
                float x_2 = i_2.high - i_2.low + halves(i_2.high);
                // control_flow.glift:43
                const uint found = address / 2u;
                const bool found_found = !(address % 2u == 0u);
                if (found_found) {
                    x_2 += float(found);
                } else {
                    x_2 = -x_2;
                }
                // control_flow.glift:44
                f_data_row[i] = mode_value_0 ? x_2 : glift::sqrt(glift::abs(x_2));
                // control_flow.glift:45
                n_data_row[i] = collatz(address) + (found_found ? found : 7u);
            }
        }
    }
}

static void control_flow_direct(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { control_flow_direct_rows(call, rows); });
}

struct control_flow_general_parameters {
    uint size;
    uint a_origin;
    uint f_origin;
    uint n_origin;
    glift::Bool mode_value_0;
};
static_assert(offsetof(control_flow_general_parameters, size) == 0);
static_assert(offsetof(control_flow_general_parameters, a_origin) == 4);
static_assert(offsetof(control_flow_general_parameters, f_origin) == 8);
static_assert(offsetof(control_flow_general_parameters, n_origin) == 12);
static_assert(offsetof(control_flow_general_parameters, mode_value_0) == 16);

// control_flow.glift:40: runs kernel control_flow for the given rows.
GLIFT_HOST_KERNEL
static void control_flow_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const control_flow_general_parameters*>(call.parameters);
    const uint a_origin = parameters.a_origin;
    const uint f_origin = parameters.f_origin;
    const uint n_origin = parameters.n_origin;
    const bool mode_value_0 = parameters.mode_value_0;
    float* f_data = glift::host::elements<float>(call.memories[0]);
    uint* n_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        if (row.begin < row.end) {
            const uint address = row.begin;
            // control_flow.glift:44
            const uint f_address = f_origin + address;
            // control_flow.glift:45
            const uint n_address = n_origin + address;
            float* f_data_row = glift::host::row_pointer(f_data + f_address);
            uint* n_data_row = glift::host::row_pointer(n_data + n_address);
            GLIFT_INDEPENDENT
            for (std::size_t i = 0, count = row.end - row.begin; i < count; ++i) {
                const uint address = row.begin + static_cast<uint>(i);
                // control_flow.glift:41
                const uint a_address = a_origin + address;
                const Interval i_2 = Interval{1.0f, float(a_address)};
                // control_flow.glift:42
                float x_2 = i_2.high - i_2.low + halves(i_2.high);
                // control_flow.glift:43
                const uint found = a_address / 2u;
                const bool found_found = !(a_address % 2u == 0u);
                if (found_found) {
                    x_2 += float(found);
                } else {
                    x_2 = -x_2;
                }
                // control_flow.glift:44
                f_data_row[i] = mode_value_0 ? x_2 : glift::sqrt(glift::abs(x_2));
                // control_flow.glift:45
                n_data_row[i] = collatz(a_address) + (found_found ? found : 7u);
            }
        }
    }
}

static void control_flow_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { control_flow_general_rows(call, rows); });
}

struct control_flow_wide_parameters {
    uint size;
    uint a_origin;
    uint f_origin;
    uint n_origin;
    glift::Bool mode_value_0;
    std::uint64_t f_data_address;
    std::uint64_t n_data_address;
};
static_assert(offsetof(control_flow_wide_parameters, size) == 0);
static_assert(offsetof(control_flow_wide_parameters, a_origin) == 4);
static_assert(offsetof(control_flow_wide_parameters, f_origin) == 8);
static_assert(offsetof(control_flow_wide_parameters, n_origin) == 12);
static_assert(offsetof(control_flow_wide_parameters, mode_value_0) == 16);
static_assert(offsetof(control_flow_wide_parameters, f_data_address) == 24);
static_assert(offsetof(control_flow_wide_parameters, n_data_address) == 32);

// control_flow.glift:40: runs kernel control_flow for the given rows.
GLIFT_HOST_KERNEL
static void control_flow_wide_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const control_flow_wide_parameters*>(call.parameters);
    const uint a_origin = parameters.a_origin;
    const uint f_origin = parameters.f_origin;
    const uint n_origin = parameters.n_origin;
    const bool mode_value_0 = parameters.mode_value_0;
    float* f_data = glift::host::elements<float>(call.memories[0]);
    uint* n_data = glift::host::elements<uint>(call.memories[1]);
    for (const glift::host::Row row : rows) {
        GLIFT_INDEPENDENT
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // control_flow.glift:41
            const uint a_address = a_origin + address;
            // control_flow.glift:44
            const uint f_address = f_origin + address;
            // control_flow.glift:40
            const std::uint64_t f_at = std::uint64_t(f_address);
            // control_flow.glift:45
            const uint n_address = n_origin + address;
            // control_flow.glift:40
            const std::uint64_t n_at = std::uint64_t(n_address);
            // control_flow.glift:41
            const Interval i_2 = Interval{1.0f, float(a_address)};
            // control_flow.glift:42
            float x_2 = i_2.high - i_2.low + halves(i_2.high);
            // control_flow.glift:43
            const uint found = a_address / 2u;
            const bool found_found = !(a_address % 2u == 0u);
            if (found_found) {
                x_2 += float(found);
            } else {
                x_2 = -x_2;
            }
            // control_flow.glift:44
            f_data[f_at] = mode_value_0 ? x_2 : glift::sqrt(glift::abs(x_2));
            // control_flow.glift:45
            n_data[n_at] = collatz(a_address) + (found_found ? found : 7u);
        }
    }
}

static void control_flow_wide(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { control_flow_wide_rows(call, rows); });
}

const glift::Binding control_flow_bindings[] = {
    {.name = "f.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 24,
        .element_bytes = sizeof(float), .parameter = 1, .reach = glift::Reach::element},
    {.name = "n.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write, .address_offset = 32,
        .element_bytes = sizeof(uint), .parameter = 2, .reach = glift::Reach::element},
};
constexpr glift::Parameter control_flow_parameters[] = {
    {"a_extent", 0, sizeof(control_flow_direct_parameters::a_extent)},
    {"mode_value_0", 4, sizeof(control_flow_direct_parameters::mode_value_0)},
};
}  // namespace

extern const glift::Kernel control_flow_kernel;
const glift::Kernel control_flow_kernel = {
    .name = "control_flow",
    .file = "control_flow.glift",
    .line = 40,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = UINT64_MAX,
    .bindings = control_flow_bindings,
    .direct = {.host = &control_flow_direct, .parameter_bytes = 8, .push_constants = true},
    .general = {.host = &control_flow_general, .parameter_bytes = 20},
    .wide = {.host = &control_flow_wide, .parameter_bytes = 40},
    .parameters = control_flow_parameters,
    .reports = true,
    .longest_loop = {"control_flow.glift", 32},
};

}  // namespace control_flow

