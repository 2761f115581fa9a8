// Made by gliftc from near.glift. Changes are lost when it is made again.
#include "near.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace near_ {

using namespace glift::types;

namespace {
struct smooth_direct_parameters {
    uint3 f_extent;
};
static_assert(offsetof(smooth_direct_parameters, f_extent) == 0);
struct smooth_general_parameters {
    uint3 size;
    uint3 f_origin;
    uint3 g_origin;
    uint3 f_extent;
    uint3 g_extent;
};
static_assert(offsetof(smooth_general_parameters, size) == 0);
static_assert(offsetof(smooth_general_parameters, f_origin) == 12);
static_assert(offsetof(smooth_general_parameters, g_origin) == 24);
static_assert(offsetof(smooth_general_parameters, f_extent) == 36);
static_assert(offsetof(smooth_general_parameters, g_extent) == 48);
struct smooth_wide_parameters {
    uint3 size;
    uint3 f_origin;
    uint3 g_origin;
    uint3 base;
    std::uint64_t f_extent_y;
    std::uint64_t f_extent_x;
    std::uint64_t g_extent_y;
    std::uint64_t g_extent_x;
    uint3 f_extent;
    std::uint64_t f_data_address;
    std::uint64_t g_data_address;
};
static_assert(offsetof(smooth_wide_parameters, size) == 0);
static_assert(offsetof(smooth_wide_parameters, f_origin) == 12);
static_assert(offsetof(smooth_wide_parameters, g_origin) == 24);
static_assert(offsetof(smooth_wide_parameters, base) == 36);
static_assert(offsetof(smooth_wide_parameters, f_extent_y) == 48);
static_assert(offsetof(smooth_wide_parameters, f_extent_x) == 56);
static_assert(offsetof(smooth_wide_parameters, g_extent_y) == 64);
static_assert(offsetof(smooth_wide_parameters, g_extent_x) == 72);
static_assert(offsetof(smooth_wide_parameters, f_extent) == 80);
static_assert(offsetof(smooth_wide_parameters, f_data_address) == 96);
static_assert(offsetof(smooth_wide_parameters, g_data_address) == 104);
}  // namespace

extern const glift::Kernel smooth_kernel;

void smooth(const glift::Commands& commands, const glift::Range<Field>& f, const glift::Range<Field>& g) {
    glift::Iteration iteration(smooth_kernel);
    iteration.each("g", g);
    iteration.near("f", f);
    const glift::Memory memories[] = {f->data(), g->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {f, g});
    if (commands.needs_wide(smooth_kernel, memories, iteration.size())) {
        const smooth_wide_parameters parameters = {
            .size = g.size(),
            .f_origin = iteration.centre(f),
            .g_origin = g.origin(),
            .base = {},
            .f_extent_y = std::uint64_t(f->extent().y),
            .f_extent_x = std::uint64_t(f->extent().x),
            .g_extent_y = std::uint64_t(g->extent().y),
            .g_extent_x = std::uint64_t(g->extent().x),
            .f_extent = f->extent(),
            .f_data_address = 0u,
            .g_data_address = 0u,
        };
        commands.dispatch(smooth_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(smooth_wide_parameters, size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && f->same_state(g.structure())) {
        const smooth_direct_parameters parameters = {
            .f_extent = f->extent(),
        };
        commands.dispatch(smooth_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const smooth_general_parameters parameters = {
            .size = g.size(),
            .f_origin = iteration.centre(f),
            .g_origin = g.origin(),
            .f_extent = f->extent(),
            .g_extent = g->extent(),
        };
        commands.dispatch(smooth_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(smooth_general_parameters, size)}), .sharing = iteration.sharing()});
    }
}

}  // namespace near_
