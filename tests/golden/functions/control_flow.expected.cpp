// Made by gliftc from control_flow.glift. Changes are lost when it is made again.
#include "control_flow.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace control_flow {

using namespace glift::types;

extern const glift::Kernel control_flow_kernel;

void control_flow(const glift::Commands& commands, const glift::Range<Line>& a, const glift::Range<Line>& f,
    const glift::Range<Numbers>& n, uint mode) {
    glift::Iteration iteration(control_flow_kernel);
    iteration.each("a", a);
    iteration.each("f", f);
    iteration.each("n", n);
    const glift::Memory memories[] = {f->data(), n->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {a, f, n});
    if (iteration.can_be_direct(commands, memories) && a->same_state(f.structure())) {
        const struct {
            uint a_extent;
            glift::Bool mode_value_0;
        } parameters = {a->extent(), mode == 0u};
        static_assert(sizeof parameters == 8);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint a_origin;
            uint f_origin;
            uint n_origin;
            glift::Bool mode_value_0;
            std::uint64_t addresses[2];
        } parameters = {a.size(), a.origin(), f.origin(), n.origin(), mode == 0u, {}};
        static_assert(sizeof parameters == 40);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

void control_flow(const glift::Commands& commands, const glift::Range<Line>& f, const glift::Range<Numbers>& n,
    uint mode) {
    control_flow(commands, f, f, n, mode);
}

}  // namespace control_flow
