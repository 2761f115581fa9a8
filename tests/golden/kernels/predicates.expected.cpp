// Made by gliftc from predicates.glift. Changes are lost when it is made again.
#include "predicates.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace predicates {

using namespace glift::types;

extern const glift::Kernel shift_kernel;

void shift(const glift::Commands& commands, const glift::Range<Line>& x, const glift::Range<Line>& from, uint by,
    const glift::Range<Line>& to) {
    glift::Iteration iteration(shift_kernel);
    iteration.each("x", x);
    iteration.each("to", to);
    iteration.any("from", from);
    const glift::Memory memories[] = {from->data(), x->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {x, from, to});
    if (iteration.can_be_direct(commands, memories) && x->same_state(from.structure())
        && from->same_state(to.structure())) {
        const struct {
            uint x_extent;
            uint by;
        } parameters = {x->extent(), by};
        static_assert(sizeof parameters == 8);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint from_origin;
            uint from_size;
            uint x_origin;
            uint to_origin;
            uint by;
            std::uint64_t addresses[3];
        } parameters = {x.size(), from.origin(), from.size(), x.origin(), to.origin(), by, {}};
        static_assert(sizeof parameters == 48);
        iteration.count(from, 8);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel pick_kernel;

void pick(const glift::Commands& commands, const glift::Range<Line>& x, const glift::Range<Line>& to) {
    glift::Iteration iteration(pick_kernel);
    iteration.each("x", x);
    iteration.each("to", to);
    const glift::Memory memories[] = {x->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {x, to});
    if (iteration.can_be_direct(commands, memories) && x->same_state(to.structure())) {
        const struct {
            uint x_extent;
        } parameters = {x->extent()};
        static_assert(sizeof parameters == 4);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint x_origin;
            uint to_origin;
            std::uint64_t addresses[2];
        } parameters = {x.size(), x.origin(), to.origin(), {}};
        static_assert(sizeof parameters == 32);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

}  // namespace predicates
