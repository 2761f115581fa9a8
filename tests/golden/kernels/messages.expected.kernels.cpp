// Made by gliftc from messages.glift. Changes are lost when it is made again.
#include "messages.glift.types.hpp"

#include <glift/host/math.h>
#include <glift/host/messages.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace messages {

using namespace glift::types;

// messages.glift:17: roots

namespace {
struct roots_general_parameters {
    uint size;
    uint f_origin;
    std::uint64_t f_data_address;
};
static_assert(sizeof(roots_general_parameters) == 16);

GLIFT_HOST_KERNEL
static void roots_general_rows(const glift::HostCall& call, const glift::host::Rows& rows) {
    const auto& parameters = *static_cast<const roots_general_parameters*>(call.parameters);
    const uint f_origin = parameters.f_origin;
    float* f_data = glift::host::elements<float>(call.memories[0]);
    for (const glift::host::Row row : rows) {
        for (uint x = row.begin; x < row.end; ++x) {
            const uint address = x;
            // messages.glift:18
            const uint f_address = f_origin + address;
            const float f_value = f_data[f_address];
            const uint kind = f_value > 1.0f ? 1u : 0u;
            // messages.glift:19
            const float2 printed = float2(f_value, -f_value);
            glift::host::print(call, 0u, {f_address, uint(kind), glift::floatBitsToUint(printed.x),
                glift::floatBitsToUint(printed.y)});
            // messages.glift:13
            if (!(f_value >= 0.0f)) {
                const uint value = glift::floatBitsToUint(f_value);
                glift::host::print(call, 1u, {f_address, value, value});
            }
            // messages.glift:20
            const float checked = glift::sqrt(f_value);
            f_data[f_address] = checked;
        }
    }
}

static void roots_general(const glift::HostCall& call) {
    glift::host::for_rows(call.size, [&](const glift::host::Rows& rows) { roots_general_rows(call, rows); });
}

const glift::Binding roots_bindings[] = {
    {.name = "f.data", .access = glift::Access::read_write, .address_offset = 8, .element_bytes = sizeof(float),
        .reach = glift::Reach::element},
};
constexpr glift::Parameter roots_parameters[] = {{"f_extent", 0, 4}};
constexpr glift::MessageFormat roots_messages[] = {
    {"{e 0=solid 1=liquid} {{{{{f}, {f}}}}}", "messages.glift", 19},
    {"x >= 0.0 (x = {f}): no root of {f}", "messages.glift", 13, true},
};
}  // namespace

extern const glift::Kernel roots_kernel;
const glift::Kernel roots_kernel = {
    .name = "roots",
    .file = "messages.glift",
    .line = 17,
    .rank = 1,
    .group = {256, 1, 1},
    .loop_rounds = 0,
    .bindings = roots_bindings,
    .direct = {.parameter_bytes = 4, .push_constants = true},
    .general = {.host = &roots_general, .parameter_bytes = 16, .uniform_buffer = true},
    .parameters = roots_parameters,
    .messages = roots_messages,
    .address_rank = 1,
};

}  // namespace messages

