// Made by gliftc from coherent.glift. Changes are lost when it is made again.
#include "coherent.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace coherent {

using namespace glift::types;

namespace {
struct take_turns_direct_parameters {
    uint a_extent;
    uint state_value_inside;
    glift::Bool state_value_inside_2;
};
static_assert(offsetof(take_turns_direct_parameters, a_extent) == 0);
static_assert(offsetof(take_turns_direct_parameters, state_value_inside) == 4);
static_assert(offsetof(take_turns_direct_parameters, state_value_inside_2) == 8);
struct take_turns_general_parameters {
    uint size;
    uint state_origin;
    uint state_size;
    uint a_origin;
    uint to_origin;
};
static_assert(offsetof(take_turns_general_parameters, size) == 0);
static_assert(offsetof(take_turns_general_parameters, state_origin) == 4);
static_assert(offsetof(take_turns_general_parameters, state_size) == 8);
static_assert(offsetof(take_turns_general_parameters, a_origin) == 12);
static_assert(offsetof(take_turns_general_parameters, to_origin) == 16);
struct take_turns_wide_parameters {
    uint size;
    uint state_origin;
    uint state_size;
    uint a_origin;
    uint to_origin;
    std::uint64_t state_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(take_turns_wide_parameters, size) == 0);
static_assert(offsetof(take_turns_wide_parameters, state_origin) == 4);
static_assert(offsetof(take_turns_wide_parameters, state_size) == 8);
static_assert(offsetof(take_turns_wide_parameters, a_origin) == 12);
static_assert(offsetof(take_turns_wide_parameters, to_origin) == 16);
static_assert(offsetof(take_turns_wide_parameters, state_data_address) == 24);
static_assert(offsetof(take_turns_wide_parameters, to_data_address) == 32);
}  // namespace

extern const glift::Kernel take_turns_kernel;

void take_turns(const glift::Commands& commands, const glift::Range<Values>& a, const glift::Range<Values>& state,
    const glift::Range<Values>& to) {
    glift::Iteration iteration(take_turns_kernel);
    iteration.each("a", a);
    iteration.each("to", to);
    iteration.any("state", state);
    const glift::Memory memories[] = {state->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {a, state, to});
    if (commands.needs_wide(take_turns_kernel, memories, iteration.size())) {
        const take_turns_wide_parameters parameters = {
            .size = a.size(),
            .state_origin = state.origin(),
            .state_size = state.size(),
            .a_origin = a.origin(),
            .to_origin = to.origin(),
            .state_data_address = 0u,
            .to_data_address = 0u,
        };
        iteration.count(state, offsetof(take_turns_wide_parameters, state_size));
        commands.dispatch(take_turns_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(take_turns_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && a->same_state(state.structure()) && state->same_state(to.structure())) {
        const take_turns_direct_parameters parameters = {
            .a_extent = a->extent(),
            .state_value_inside = 0u < a->extent() ? 0u : 0u,
            .state_value_inside_2 = 0u < a->extent(),
        };
        commands.dispatch(take_turns_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const take_turns_general_parameters parameters = {
            .size = a.size(),
            .state_origin = state.origin(),
            .state_size = state.size(),
            .a_origin = a.origin(),
            .to_origin = to.origin(),
        };
        iteration.count(state, offsetof(take_turns_general_parameters, state_size));
        commands.dispatch(take_turns_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(take_turns_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void take_turns(const glift::Commands& commands, const glift::Range<Values>& state, const glift::Range<Values>& to) {
    take_turns(commands, to, state, to);
}

}  // namespace coherent
