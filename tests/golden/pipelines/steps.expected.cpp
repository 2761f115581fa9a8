// Made by gliftc from steps.glift. Changes are lost when it is made again.
#include "steps.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace steps {

using namespace glift::types;

extern const glift::Kernel ramp_kernel;

void ramp(const glift::Commands& commands, const glift::Range<Line>& a, const glift::Range<Line>& f) {
    glift::Iteration iteration(ramp_kernel);
    iteration.each("a", a);
    iteration.each("f", f);
    const glift::Memory memories[] = {f->data()};
    if (iteration.can_be_direct(commands, memories) && a->same_state(f.structure())) {
        const struct {
            uint a_extent;
        } parameters = {a->extent()};
        static_assert(sizeof parameters == 4);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint a_origin;
            uint f_origin;
            std::uint64_t addresses[1];
        } parameters = {a.size(), a.origin(), f.origin(), {}};
        static_assert(sizeof parameters == 24);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel smooth_kernel;

void smooth(const glift::Commands& commands, const glift::Range<Line>& f, const glift::Range<Line>& g) {
    glift::Iteration iteration(smooth_kernel);
    iteration.each("g", g);
    iteration.near("f", f);
    const glift::Memory memories[] = {f->data(), g->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {f, g});
    if (iteration.can_be_direct(commands, memories) && f->same_state(g.structure())) {
        const struct {
            uint f_extent;
        } parameters = {f->extent()};
        static_assert(sizeof parameters == 4);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint f_origin;
            uint g_origin;
            uint f_extent;
            std::uint64_t addresses[2];
        } parameters = {g.size(), iteration.centre(f), g.origin(), f->extent(), {}};
        static_assert(sizeof parameters == 32);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

// steps.glift:11: smoothed
void smoothed(const glift::Commands& commands, const Line& g, uint rounds) {
    const glift::PipelineMark _mark("smoothed", "steps.glift:11");
    // steps.glift:12
    Line a(commands, g.extent());
    // steps.glift:13
    Line b(commands, g.extent());
    // steps.glift:14
    ramp(commands, a, a);
    // steps.glift:15
    for (uint i = 0u; i < rounds; ++i) {
        // steps.glift:16
        smooth(commands, a, b);
        // steps.glift:17
        smooth(commands, b, a);
    }
    b = {};
    // steps.glift:19
    smooth(commands, a, g);
    a = {};
}

}  // namespace steps
