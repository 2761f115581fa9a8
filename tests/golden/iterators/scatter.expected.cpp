// Made by gliftc from scatter.glift. Changes are lost when it is made again.
#include "scatter.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace scatter {

using namespace glift::types;

extern const glift::Kernel histogram_kernel;

void histogram(const glift::Commands& commands, const glift::Range<Samples>& s, const glift::Range<Samples>& bins) {
    glift::Iteration iteration(histogram_kernel);
    iteration.each("s", s);
    iteration.any("bins", bins);
    const glift::Memory memories[] = {s->data(), bins->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {s, bins});
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint s_extent;
            uint bins_extent;
            uint bins_data_copied;
        } parameters = {s->extent(), bins->extent(), glift::min(glift::fitted(bins->data_extent()), 64u) < 4128u
            ? glift::min(glift::fitted(bins->data_extent()), 64u) : 0u};
        static_assert(sizeof parameters == 12);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint s_origin;
            uint bins_origin;
            uint bins_size;
            uint bins_data_copied;
            std::uint64_t addresses[2];
        } parameters = {s.size(), s.origin(), bins.origin(), bins.size(), glift::fitted(bins->data_extent()) < 4128u
            ? glift::fitted(bins->data_extent()) : 0u, {}};
        static_assert(sizeof parameters == 40);
        iteration.count(bins, 12);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

}  // namespace scatter
