// Made by gliftc from any.glift. Changes are lost when it is made again.
#include "any.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace any {

using namespace glift::types;

extern const glift::Kernel gather_kernel;

void gather(const glift::Commands& commands, const glift::Range<Values>& values, const glift::Range<Indices>& index,
    const glift::Range<Values>& g) {
    glift::Iteration iteration(gather_kernel);
    iteration.each("index", index);
    iteration.each("g", g);
    iteration.any("values", values);
    const glift::Memory memories[] = {index->data(), values->data(), g->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {values, index, g});
    if (iteration.can_be_direct(commands, memories) && values->same_state(g.structure())) {
        const struct {
            uint index_extent;
            uint values_extent;
        } parameters = {index->extent(), values->extent()};
        static_assert(sizeof parameters == 8);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint index_origin;
            uint values_origin;
            uint values_size;
            uint g_origin;
            std::uint64_t addresses[3];
        } parameters = {index.size(), index.origin(), values.origin(), values.size(), g.origin(), {}};
        static_assert(sizeof parameters == 48);
        iteration.count(values, 12);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

}  // namespace any
