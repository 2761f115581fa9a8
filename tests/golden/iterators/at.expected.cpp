// Made by gliftc from at.glift. Changes are lost when it is made again.
#include "at.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace at {

using namespace glift::types;

extern const glift::Kernel ramp_kernel;

void ramp(const glift::Commands& commands, const glift::Range<Field>& a, const glift::Range<Field>& f) {
    glift::Iteration iteration(ramp_kernel);
    iteration.each("a", a);
    iteration.each("f", f);
    const glift::Memory memories[] = {f->data()};
    if (iteration.can_be_direct(commands, memories) && a->same_state(f.structure())) {
        const struct {
            uint2 a_extent;
        } parameters = {a->extent()};
        static_assert(sizeof parameters == 8);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint2 size;
            uint2 a_origin;
            uint2 f_origin;
            uint3 base;
            uint f_extent_x;
            std::uint64_t addresses[1];
        } parameters = {a.size(), a.origin(), f.origin(), {}, f->extent().x, {}};
        static_assert(sizeof parameters == 48);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

void ramp(const glift::Commands& commands, const glift::Range<Field>& f) {
    ramp(commands, f, f);
}

}  // namespace at
