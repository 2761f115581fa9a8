// Made by gliftc from scatter.glift. Changes are lost when it is made again.
#include "scatter.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace scatter {

using namespace glift::types;

namespace {
struct histogram_direct_parameters {
    uint s_extent;
    uint bins_extent;
};
static_assert(offsetof(histogram_direct_parameters, s_extent) == 0);
static_assert(offsetof(histogram_direct_parameters, bins_extent) == 4);
struct histogram_general_parameters {
    uint size;
    uint s_origin;
    uint bins_origin;
    uint bins_size;
};
static_assert(offsetof(histogram_general_parameters, size) == 0);
static_assert(offsetof(histogram_general_parameters, s_origin) == 4);
static_assert(offsetof(histogram_general_parameters, bins_origin) == 8);
static_assert(offsetof(histogram_general_parameters, bins_size) == 12);
struct histogram_wide_parameters {
    uint size;
    uint s_origin;
    uint bins_origin;
    uint bins_size;
    std::uint64_t s_data_address;
    std::uint64_t bins_data_address;
};
static_assert(offsetof(histogram_wide_parameters, size) == 0);
static_assert(offsetof(histogram_wide_parameters, s_origin) == 4);
static_assert(offsetof(histogram_wide_parameters, bins_origin) == 8);
static_assert(offsetof(histogram_wide_parameters, bins_size) == 12);
static_assert(offsetof(histogram_wide_parameters, s_data_address) == 16);
static_assert(offsetof(histogram_wide_parameters, bins_data_address) == 24);
}  // namespace

extern const glift::Kernel histogram_kernel;

void histogram(const glift::Commands& commands, const glift::Range<Samples>& s, const glift::Range<Samples>& bins) {
    glift::Iteration iteration(histogram_kernel);
    iteration.each("s", s);
    iteration.any("bins", bins);
    const glift::Memory memories[] = {s->data(), bins->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {s, bins});
    if (commands.needs_wide(histogram_kernel, memories, iteration.size())) {
        const histogram_wide_parameters parameters = {
            .size = s.size(),
            .s_origin = s.origin(),
            .bins_origin = bins.origin(),
            .bins_size = bins.size(),
            .s_data_address = 0u,
            .bins_data_address = 0u,
        };
        iteration.count(bins, offsetof(histogram_wide_parameters, bins_size));
        commands.dispatch(histogram_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(histogram_wide_parameters, size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const histogram_direct_parameters parameters = {
            .s_extent = s->extent(),
            .bins_extent = bins->extent(),
        };
        commands.dispatch(histogram_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const histogram_general_parameters parameters = {
            .size = s.size(),
            .s_origin = s.origin(),
            .bins_origin = bins.origin(),
            .bins_size = bins.size(),
        };
        iteration.count(bins, offsetof(histogram_general_parameters, bins_size));
        commands.dispatch(histogram_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(histogram_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

}  // namespace scatter
