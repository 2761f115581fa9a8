// Made by gliftc from messages.glift. Changes are lost when it is made again.
#include "messages.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace messages {

using namespace glift::types;

extern const glift::Kernel roots_kernel;

void roots(const glift::Commands& commands, const glift::Range<Line>& f) {
    glift::Iteration iteration(roots_kernel);
    iteration.each("f", f);
    const glift::Memory memories[] = {f->data()};
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint f_extent;
        } parameters = {f->extent()};
        static_assert(sizeof parameters == 4);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint f_origin;
            std::uint64_t addresses[1];
        } parameters = {f.size(), f.origin(), {}};
        static_assert(sizeof parameters == 16);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

}  // namespace messages
