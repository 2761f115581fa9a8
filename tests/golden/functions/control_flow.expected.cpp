// Made by gliftc from control_flow.glift. Changes are lost when it is made again.
#include "control_flow.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace control_flow {

using namespace glift::types;

namespace {
struct control_flow_direct_parameters {
    uint a_extent;
    glift::Bool mode_value_0;
};
static_assert(offsetof(control_flow_direct_parameters, a_extent) == 0);
static_assert(offsetof(control_flow_direct_parameters, mode_value_0) == 4);
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
}  // namespace

extern const glift::Kernel control_flow_kernel;

void control_flow(const glift::Commands& commands, const glift::Range<Line>& a, const glift::Range<Line>& f,
    const glift::Range<Numbers>& n, uint mode) {
    glift::Iteration iteration(control_flow_kernel);
    iteration.each("a", a);
    iteration.each("f", f);
    iteration.each("n", n);
    const glift::Memory memories[] = {f->data(), n->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {a, f, n});
    if (commands.needs_wide(control_flow_kernel, memories, iteration.size())) {
        const control_flow_wide_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .f_origin = f.origin(),
            .n_origin = n.origin(),
            .mode_value_0 = mode == 0u,
            .f_data_address = 0u,
            .n_data_address = 0u,
        };
        commands.dispatch(control_flow_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(control_flow_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && a->same_state(f.structure())) {
        const control_flow_direct_parameters parameters = {
            .a_extent = a->extent(),
            .mode_value_0 = mode == 0u,
        };
        commands.dispatch(control_flow_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const control_flow_general_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .f_origin = f.origin(),
            .n_origin = n.origin(),
            .mode_value_0 = mode == 0u,
        };
        commands.dispatch(control_flow_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(control_flow_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void control_flow(const glift::Commands& commands, const glift::Range<Line>& f, const glift::Range<Numbers>& n,
    uint mode) {
    control_flow(commands, f, f, n, mode);
}

}  // namespace control_flow
