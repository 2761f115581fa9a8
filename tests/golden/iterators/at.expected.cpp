// Made by gliftc from at.glift. Changes are lost when it is made again.
#include "at.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace at {

using namespace glift::types;

namespace {
struct ramp_direct_parameters {
    uint2 a_extent;
};
static_assert(offsetof(ramp_direct_parameters, a_extent) == 0);
struct ramp_general_parameters {
    uint2 size;
    uint2 a_origin;
    uint2 f_origin;
    uint f_extent_x;
};
static_assert(offsetof(ramp_general_parameters, size) == 0);
static_assert(offsetof(ramp_general_parameters, a_origin) == 8);
static_assert(offsetof(ramp_general_parameters, f_origin) == 16);
static_assert(offsetof(ramp_general_parameters, f_extent_x) == 24);
struct ramp_wide_parameters {
    uint2 size;
    uint2 a_origin;
    uint2 f_origin;
    uint3 base;
    std::uint64_t f_extent_x;
    std::uint64_t f_data_address;
};
static_assert(offsetof(ramp_wide_parameters, size) == 0);
static_assert(offsetof(ramp_wide_parameters, a_origin) == 8);
static_assert(offsetof(ramp_wide_parameters, f_origin) == 16);
static_assert(offsetof(ramp_wide_parameters, base) == 24);
static_assert(offsetof(ramp_wide_parameters, f_extent_x) == 40);
static_assert(offsetof(ramp_wide_parameters, f_data_address) == 48);
}  // namespace

extern const glift::Kernel ramp_kernel;

void ramp(const glift::Commands& commands, const glift::Range<Field>& a, const glift::Range<Field>& f) {
    glift::Iteration iteration(ramp_kernel);
    iteration.each("a", a);
    iteration.each("f", f);
    const glift::Memory memories[] = {f->data()};
    if (commands.needs_wide(ramp_kernel, memories, iteration.size())) {
        const ramp_wide_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .f_origin = f.origin(),
            .base = {},
            .f_extent_x = std::uint64_t(f->extent().x),
            .f_data_address = 0u,
        };
        commands.dispatch(ramp_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(ramp_wide_parameters, size)})});
    } else if (iteration.is_whole() && a->same_state(f.structure())) {
        const ramp_direct_parameters parameters = {
            .a_extent = a->extent(),
        };
        commands.dispatch(ramp_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const ramp_general_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .f_origin = f.origin(),
            .f_extent_x = f->extent().x,
        };
        commands.dispatch(ramp_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(ramp_general_parameters, size)})});
    }
}

void ramp(const glift::Commands& commands, const glift::Range<Field>& f) {
    ramp(commands, f, f);
}

}  // namespace at
