// Made by gliftc from fours.glift. Changes are lost when it is made again.
#include "fours.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace fours {

using namespace glift::types;

extern const glift::Kernel sum_fours_kernel;

void sum_fours(const glift::Commands& commands, const glift::Range<Values>& a, const glift::Range<Values>& from,
    uint shift, const glift::Range<Values>& to) {
    glift::Iteration iteration(sum_fours_kernel);
    iteration.each("a", a);
    iteration.any("from", from);
    iteration.any("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {a, from, to});
    if (iteration.can_be_direct(commands, memories) && a->same_state(from.structure())
        && from->same_state(to.structure())) {
        const struct {
            uint a_extent;
            uint shift;
        } parameters = {a->extent(), shift};
        static_assert(sizeof parameters == 8);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint from_origin;
            uint from_size;
            uint to_origin;
            uint to_size;
            uint shift;
            std::uint64_t addresses[2];
        } parameters = {a.size(), from.origin(), from.size(), to.origin(), to.size(), shift, {}};
        static_assert(sizeof parameters == 40);
        iteration.count(from, 8);
        iteration.count(to, 16);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

void sum_fours(const glift::Commands& commands, const glift::Range<Values>& from, uint shift,
    const glift::Range<Values>& to) {
    sum_fours(commands, from, from, shift, to);
}

}  // namespace fours
