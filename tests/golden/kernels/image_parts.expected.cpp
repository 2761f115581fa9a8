// Made by gliftc from image_parts.glift. Changes are lost when it is made again.
#include "image_parts.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace image_parts {

using namespace glift::types;

extern const glift::Kernel halve_kernel;

void halve(const glift::Commands& commands, const glift::Range<Level>& fine, const glift::Range<Level>& a,
    const glift::Range<Level>& to) {
    glift::Iteration iteration(halve_kernel);
    iteration.each("a", a);
    iteration.each("to", to);
    iteration.any("fine", fine);
    const glift::Memory memories[] = {fine->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {fine, a, to});
    if (iteration.can_be_direct(commands, memories) && fine->same_state(a.structure())
        && a->same_state(to.structure())) {
        const struct {
            uint2 fine_data_extent;
        } parameters = {fine->data_extent()};
        static_assert(sizeof parameters == 8);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint2 size;
            uint2 a_origin;
            uint2 fine_origin;
            uint2 fine_size;
            uint2 to_origin;
            uint3 base;
        } parameters = {a.size(), a.origin(), fine.origin(), fine.size(), to.origin(), {}};
        static_assert(sizeof parameters == 52);
        iteration.count(fine, 24);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

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
    if (iteration.can_be_direct(commands, memories) && a->same_state(to.structure())) {
        const struct {
            uint2 a_data_extent;
            float2 from_data_extent;
            float level;
            float layers_data_extent_x;
            float layers_data_extent_y;
        } parameters = {a->data_extent(), float2(from->data_extent()), float(level), float(layers->data_extent().x),
            float(layers->data_extent().y)};
        static_assert(sizeof parameters == 28);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
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
        } parameters = {a.size(), a.origin(), from.origin(), layers.origin(), to.origin(), {},
            float2(from->data_extent()), float(level), float(layers->data_extent().x), float(layers->data_extent().y)};
        static_assert(sizeof parameters == 76);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

// image_parts.glift:17: build
void build(const glift::Commands& commands, const Levels& all) {
    const glift::PipelineMark _mark("build", "image_parts.glift:17");
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
