// Made by gliftc from draws.glift. Changes are lost when it is made again.
#include "draws.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace draws {

using namespace glift::types;

extern const glift::Kernel draw_mesh_kernel;

void draw_mesh(const glift::Commands& commands, const glift::Range<Corners>& corner, const glift::Range<Points>& points,
    float4x4 camera, const glift::Range<Colour>& colour, const glift::Range<Depth>& depth) {
    glift::DrawIteration iteration(draw_mesh_kernel);
    iteration.corners("corner", corner);
    iteration.any("points", points);
    iteration.colour("colour", colour, colour->data());
    iteration.depth("depth", depth, depth->data());
    const glift::Memory memories[] = {corner->data(), points->data()};
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint points_extent;
            float4x4 camera;
        } parameters = {points->extent(), camera};
        static_assert(sizeof parameters == 68);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint2 size;
            uint corner_origin;
            uint points_origin;
            uint points_size;
            uint2 colour_origin;
            float4x4 camera;
            std::uint64_t addresses[2];
        } parameters = {iteration.counts(), corner.origin(), points.origin(), points.size(), colour.origin(), camera,
            {}};
        static_assert(sizeof parameters == 112);
        iteration.count(points, 16);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel draw_marks_kernel;

void draw_marks(const glift::Commands& commands, const glift::Range<Points>& corner, const glift::Range<Points>& mark,
    const glift::Range<Colour>& image, const glift::Range<Depth>& depth) {
    glift::DrawIteration iteration(draw_marks_kernel);
    iteration.corners("corner", corner);
    iteration.instances("mark", mark);
    iteration.colour("image", image, image->data());
    iteration.depth("depth", depth, depth->data());
    const glift::Memory memories[] = {corner->data(), mark->data()};
    if (iteration.can_be_direct(commands, memories)) {
        iteration.dispatch(commands, glift::FormName::direct, memories, {});
    } else {
        const struct {
            uint2 size;
            uint corner_origin;
            uint mark_origin;
            uint2 image_origin;
            std::uint64_t addresses[2];
        } parameters = {iteration.counts(), corner.origin(), mark.origin(), image.origin(), {}};
        static_assert(sizeof parameters == 40);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel even_kernel;

void even(const glift::Commands& commands, const glift::Range<Points>& corner, float factor,
    const glift::Range<Colour>& image) {
    glift::DrawIteration iteration(even_kernel);
    iteration.corners("corner", corner);
    iteration.colour("image", image, image->data());
    const glift::Memory memories[] = {corner->data()};
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            float factor;
            float2 factor_2;
        } parameters = {factor, float2(factor, 2.0f)};
        static_assert(sizeof parameters == 12);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint2 size;
            uint corner_origin;
            uint2 image_origin;
            float factor;
            float2 factor_2;
            std::uint64_t addresses[1];
        } parameters = {iteration.counts(), corner.origin(), image.origin(), factor, float2(factor, 2.0f), {}};
        static_assert(sizeof parameters == 40);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

// draws.glift:83: frame
void frame(const glift::Commands& commands, const Corners& corners, const Points& points, float4x4 camera,
    const Points& marks, const Corners& number, const Colour& image) {
    const glift::PipelineMark _mark("frame", "draws.glift:83");
    // draws.glift:85
    Depth z(commands, image.extent());
    // draws.glift:86
    ::std_image::clear_depth_89866a9c(commands, z, 1.0f);
    // draws.glift:87
    draw_mesh(commands, corners, points, camera, image, z);
    // draws.glift:88
    const glift::DeviceScalar<uint> n = number.element(commands, 0u);
    // draws.glift:89
    draw_marks(commands, glift::slice(points, 0u, 3u, "draws.glift:89"), marks.first(n),
        glift::slice(image, uint2(0u, 0u), uint2(8u, 8u), "draws.glift:89"),
        glift::slice(z, uint2(0u, 0u), uint2(8u, 8u), "draws.glift:89"));
    z = {};
}

}  // namespace draws
