// Made by gliftc from marks.glift. Changes are lost when it is made again.
#include "marks.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace marks {

using namespace glift::types;

extern const glift::Kernel set_kernel;

void set(const glift::Commands& commands, const glift::Range<::std_array::Array_1_float>& f, float value) {
    glift::Iteration iteration(set_kernel);
    iteration.each("f", f);
    const glift::Memory memories[] = {f->data()};
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint f_extent;
            float value;
        } parameters = {f->extent(), value};
        static_assert(sizeof parameters == 8);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint f_origin;
            float value;
            std::uint64_t addresses[1];
        } parameters = {f.size(), f.origin(), value, {}};
        static_assert(sizeof parameters == 24);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

Marks::Marks(const glift::Commands& commands, uint n)
    : device_(commands.device()),
      n_(n),
      places_(::std_array::Array_1_float(commands, n_)) {}

bool Marks::same_state(const Marks& other) const {
    return n_ == other.n_ && places_.get().same_state(other.places_.get());
}

// marks.glift:11: mark
void Marks::mark(const glift::Commands& commands) const {
    const glift::PipelineMark _mark("mark", "marks.glift:11");
    // marks.glift:12
    set(commands, places_.get(), 1.0f);
}

// marks.glift:15: mark_twice
void Marks::mark_twice(const glift::Commands& commands) const {
    const glift::PipelineMark _mark("mark_twice", "marks.glift:15");
    // marks.glift:16
    mark(commands);
    // marks.glift:17
    mark(commands);
}

}  // namespace marks
