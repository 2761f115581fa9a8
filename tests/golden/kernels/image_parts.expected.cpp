// Made by gliftc from image_parts.glift. Changes are lost when it is made again.
#include "image_parts.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace image_parts {

using namespace glift::types;

namespace {
struct halve_direct_parameters {
    uint2 fine_data_extent;
};
static_assert(offsetof(halve_direct_parameters, fine_data_extent) == 0);
struct halve_general_parameters {
    uint2 size;
    uint2 a_origin;
    uint2 fine_origin;
    uint2 fine_size;
    uint2 to_origin;
};
static_assert(offsetof(halve_general_parameters, size) == 0);
static_assert(offsetof(halve_general_parameters, a_origin) == 8);
static_assert(offsetof(halve_general_parameters, fine_origin) == 16);
static_assert(offsetof(halve_general_parameters, fine_size) == 24);
static_assert(offsetof(halve_general_parameters, to_origin) == 32);
struct halve_wide_parameters {
    uint2 size;
    uint2 a_origin;
    uint2 fine_origin;
    uint2 fine_size;
    uint2 to_origin;
    uint3 base;
};
static_assert(offsetof(halve_wide_parameters, size) == 0);
static_assert(offsetof(halve_wide_parameters, a_origin) == 8);
static_assert(offsetof(halve_wide_parameters, fine_origin) == 16);
static_assert(offsetof(halve_wide_parameters, fine_size) == 24);
static_assert(offsetof(halve_wide_parameters, to_origin) == 32);
static_assert(offsetof(halve_wide_parameters, base) == 40);
}  // namespace

extern const glift::Kernel halve_kernel;

void halve(const glift::Commands& commands, const glift::Range<Level>& fine, const glift::Range<Level>& a,
    const glift::Range<Level>& to) {
    glift::Iteration iteration(halve_kernel);
    iteration.each("a", a);
    iteration.each("to", to);
    iteration.any("fine", fine);
    const glift::Memory memories[] = {fine->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {fine, a, to});
    if (commands.needs_wide(halve_kernel, memories, iteration.size())) {
        const halve_wide_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .fine_origin = fine.origin(),
            .fine_size = fine.size(),
            .to_origin = to.origin(),
            .base = {},
        };
        iteration.count(fine, offsetof(halve_wide_parameters, fine_size));
        commands.dispatch(halve_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(halve_wide_parameters, size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && fine->same_state(a.structure()) && a->same_state(to.structure())) {
        const halve_direct_parameters parameters = {
            .fine_data_extent = fine->data_extent(),
        };
        commands.dispatch(halve_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const halve_general_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .fine_origin = fine.origin(),
            .fine_size = fine.size(),
            .to_origin = to.origin(),
        };
        iteration.count(fine, offsetof(halve_general_parameters, fine_size));
        commands.dispatch(halve_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(halve_general_parameters, size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct resample_direct_parameters {
    uint2 a_data_extent;
    float2 from_data_extent;
    float level;
    float layers_data_extent_x;
    float layers_data_extent_y;
};
static_assert(offsetof(resample_direct_parameters, a_data_extent) == 0);
static_assert(offsetof(resample_direct_parameters, from_data_extent) == 8);
static_assert(offsetof(resample_direct_parameters, level) == 16);
static_assert(offsetof(resample_direct_parameters, layers_data_extent_x) == 20);
static_assert(offsetof(resample_direct_parameters, layers_data_extent_y) == 24);
struct resample_general_parameters {
    uint2 size;
    uint2 a_origin;
    uint2 from_origin;
    uint3 layers_origin;
    uint2 to_origin;
    float2 from_data_extent;
    float level;
    float layers_data_extent_x;
    float layers_data_extent_y;
};
static_assert(offsetof(resample_general_parameters, size) == 0);
static_assert(offsetof(resample_general_parameters, a_origin) == 8);
static_assert(offsetof(resample_general_parameters, from_origin) == 16);
static_assert(offsetof(resample_general_parameters, layers_origin) == 24);
static_assert(offsetof(resample_general_parameters, to_origin) == 36);
static_assert(offsetof(resample_general_parameters, from_data_extent) == 44);
static_assert(offsetof(resample_general_parameters, level) == 52);
static_assert(offsetof(resample_general_parameters, layers_data_extent_x) == 56);
static_assert(offsetof(resample_general_parameters, layers_data_extent_y) == 60);
struct resample_wide_parameters {
    uint2 size;
    uint2 a_origin;
    uint2 from_origin;
    uint3 layers_origin;
    uint2 to_origin;
    uint3 base;
    float2 from_data_extent;
    float level;
    float layers_data_extent_x;
    float layers_data_extent_y;
};
static_assert(offsetof(resample_wide_parameters, size) == 0);
static_assert(offsetof(resample_wide_parameters, a_origin) == 8);
static_assert(offsetof(resample_wide_parameters, from_origin) == 16);
static_assert(offsetof(resample_wide_parameters, layers_origin) == 24);
static_assert(offsetof(resample_wide_parameters, to_origin) == 36);
static_assert(offsetof(resample_wide_parameters, base) == 44);
static_assert(offsetof(resample_wide_parameters, from_data_extent) == 56);
static_assert(offsetof(resample_wide_parameters, level) == 64);
static_assert(offsetof(resample_wide_parameters, layers_data_extent_x) == 68);
static_assert(offsetof(resample_wide_parameters, layers_data_extent_y) == 72);
}  // namespace

extern const glift::Kernel resample_kernel;

void resample(const glift::Commands& commands, const glift::Range<Levels>& from, const glift::Range<Layers>& layers,
    const glift::Range<Layer>& a, uint level, const glift::Range<Layer>& to) {
    glift::Iteration iteration(resample_kernel);
    iteration.each("a", a);
    iteration.each("to", to);
    iteration.any("from", from);
    iteration.any("layers", layers);
    const glift::Memory memories[] = {from->data(), layers->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, layers, a, to});
    if (commands.needs_wide(resample_kernel, memories, iteration.size())) {
        const resample_wide_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .from_origin = from.origin(),
            .layers_origin = layers.origin(),
            .to_origin = to.origin(),
            .base = {},
            .from_data_extent = float2(from->data_extent()),
            .level = float(level),
            .layers_data_extent_x = float(layers->data_extent().x),
            .layers_data_extent_y = float(layers->data_extent().y),
        };
        commands.dispatch(resample_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(resample_wide_parameters, size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && a->same_state(to.structure())) {
        const resample_direct_parameters parameters = {
            .a_data_extent = a->data_extent(),
            .from_data_extent = float2(from->data_extent()),
            .level = float(level),
            .layers_data_extent_x = float(layers->data_extent().x),
            .layers_data_extent_y = float(layers->data_extent().y),
        };
        commands.dispatch(resample_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const resample_general_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .from_origin = from.origin(),
            .layers_origin = layers.origin(),
            .to_origin = to.origin(),
            .from_data_extent = float2(from->data_extent()),
            .level = float(level),
            .layers_data_extent_x = float(layers->data_extent().x),
            .layers_data_extent_y = float(layers->data_extent().y),
        };
        commands.dispatch(resample_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(resample_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

// image_parts.glift:17: build
void build(const glift::Commands& commands, const Levels& all) {
    // image_parts.glift:18
    for (uint level = 1u, level_end = all.levels(); level < level_end; ++level) {
        // image_parts.glift:19
        Level made(commands, all, level - 1u);
        Level made_2(commands, all, level);
        halve(commands, made, made_2, made_2);
        made = {};
        made_2 = {};
    }
}

}  // namespace image_parts
