// Made by gliftc from coherent.glift. Changes are lost when it is made again.
#include "coherent.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace coherent {

using namespace glift::types;

extern const glift::Kernel take_turns_kernel;

void take_turns(const glift::Commands& commands, const glift::Range<Values>& a, const glift::Range<Values>& state,
    const glift::Range<Values>& to) {
    glift::Iteration iteration(take_turns_kernel);
    iteration.each("a", a);
    iteration.each("to", to);
    iteration.any("state", state);
    const glift::Memory memories[] = {state->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {a, state, to});
    if (iteration.can_be_direct(commands, memories) && a->same_state(state.structure())
        && state->same_state(to.structure())) {
        const struct {
            uint a_extent;
            uint state_value_inside;
            glift::Bool state_value_inside_2;
        } parameters = {a->extent(), 0u < a->extent() ? 0u : 0u, 0u < a->extent()};
        static_assert(sizeof parameters == 12);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint state_origin;
            uint state_size;
            uint a_origin;
            uint to_origin;
            std::uint64_t addresses[2];
        } parameters = {a.size(), state.origin(), state.size(), a.origin(), to.origin(), {}};
        static_assert(sizeof parameters == 40);
        iteration.count(state, 8);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

void take_turns(const glift::Commands& commands, const glift::Range<Values>& state, const glift::Range<Values>& to) {
    take_turns(commands, to, state, to);
}

}  // namespace coherent
