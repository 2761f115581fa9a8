// Made by gliftc from near.glift. Changes are lost when it is made again.
#include "near.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace near_ {

using namespace glift::types;

extern const glift::Kernel smooth_kernel;

void smooth(const glift::Commands& commands, const glift::Range<Field>& f, const glift::Range<Field>& g) {
    glift::Iteration iteration(smooth_kernel);
    iteration.each("g", g);
    iteration.near("f", f);
    const glift::Memory memories[] = {f->data(), g->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {f, g});
    if (iteration.can_be_direct(commands, memories) && f->same_state(g.structure())) {
        const struct {
            uint3 f_extent;
        } parameters = {f->extent()};
        static_assert(sizeof parameters == 12);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint3 size;
            uint3 f_origin;
            uint3 g_origin;
            uint3 base;
            uint3 f_extent;
            uint3 g_extent;
            std::uint64_t addresses[2];
        } parameters = {g.size(), iteration.centre(f), g.origin(), {}, f->extent(), g->extent(), {}};
        static_assert(sizeof parameters == 88);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

}  // namespace near_
