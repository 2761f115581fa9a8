// Made by gliftc from steps.glift. Changes are lost when it is made again.
#include "steps.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace steps {

using namespace glift::types;

namespace {
struct ramp_direct_parameters {
    uint a_extent;
};
static_assert(offsetof(ramp_direct_parameters, a_extent) == 0);
struct ramp_general_parameters {
    uint size;
    uint a_origin;
    uint f_origin;
};
static_assert(offsetof(ramp_general_parameters, size) == 0);
static_assert(offsetof(ramp_general_parameters, a_origin) == 4);
static_assert(offsetof(ramp_general_parameters, f_origin) == 8);
struct ramp_wide_parameters {
    uint size;
    uint a_origin;
    uint f_origin;
    std::uint64_t f_data_address;
};
static_assert(offsetof(ramp_wide_parameters, size) == 0);
static_assert(offsetof(ramp_wide_parameters, a_origin) == 4);
static_assert(offsetof(ramp_wide_parameters, f_origin) == 8);
static_assert(offsetof(ramp_wide_parameters, f_data_address) == 16);
}  // namespace

extern const glift::Kernel ramp_kernel;

void ramp(const glift::Commands& commands, const glift::Range<Line>& a, const glift::Range<Line>& f) {
    glift::Iteration iteration(ramp_kernel);
    iteration.each("a", a);
    iteration.each("f", f);
    const glift::Memory memories[] = {f->data()};
    if (commands.needs_wide(ramp_kernel, memories, iteration.size())) {
        const ramp_wide_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .f_origin = f.origin(),
            .f_data_address = 0u,
        };
        commands.dispatch(ramp_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(ramp_wide_parameters, size)})});
    } else if (iteration.is_whole() && a->same_state(f.structure())) {
        const ramp_direct_parameters parameters = {
            .a_extent = a->extent(),
        };
        commands.dispatch(ramp_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const ramp_general_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .f_origin = f.origin(),
        };
        commands.dispatch(ramp_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(ramp_general_parameters, size)})});
    }
}

namespace {
struct smooth_direct_parameters {
    uint f_extent;
};
static_assert(offsetof(smooth_direct_parameters, f_extent) == 0);
struct smooth_general_parameters {
    uint size;
    uint f_origin;
    uint g_origin;
    uint f_extent;
};
static_assert(offsetof(smooth_general_parameters, size) == 0);
static_assert(offsetof(smooth_general_parameters, f_origin) == 4);
static_assert(offsetof(smooth_general_parameters, g_origin) == 8);
static_assert(offsetof(smooth_general_parameters, f_extent) == 12);
struct smooth_wide_parameters {
    uint size;
    uint f_origin;
    uint g_origin;
    uint f_extent;
    std::uint64_t f_data_address;
    std::uint64_t g_data_address;
};
static_assert(offsetof(smooth_wide_parameters, size) == 0);
static_assert(offsetof(smooth_wide_parameters, f_origin) == 4);
static_assert(offsetof(smooth_wide_parameters, g_origin) == 8);
static_assert(offsetof(smooth_wide_parameters, f_extent) == 12);
static_assert(offsetof(smooth_wide_parameters, f_data_address) == 16);
static_assert(offsetof(smooth_wide_parameters, g_data_address) == 24);
}  // namespace

extern const glift::Kernel smooth_kernel;

void smooth(const glift::Commands& commands, const glift::Range<Line>& f, const glift::Range<Line>& g) {
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
        };
        commands.dispatch(smooth_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(smooth_general_parameters, size)}), .sharing = iteration.sharing()});
    }
}

// steps.glift:11: smoothed
void smoothed(const glift::Commands& commands, const Line& g, uint rounds) {
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
