// Made by gliftc from draws.glift. Changes are lost when it is made again.
#include "draws.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace draws {

using namespace glift::types;

namespace {
struct draw_mesh_direct_parameters {
    uint points_extent;
    float4x4 camera;
};
static_assert(offsetof(draw_mesh_direct_parameters, points_extent) == 0);
static_assert(offsetof(draw_mesh_direct_parameters, camera) == 4);
struct draw_mesh_general_parameters {
    uint2 size;
    uint corner_origin;
    uint points_origin;
    uint points_size;
    uint2 colour_origin;
    float4x4 camera;
};
static_assert(offsetof(draw_mesh_general_parameters, size) == 0);
static_assert(offsetof(draw_mesh_general_parameters, corner_origin) == 8);
static_assert(offsetof(draw_mesh_general_parameters, points_origin) == 12);
static_assert(offsetof(draw_mesh_general_parameters, points_size) == 16);
static_assert(offsetof(draw_mesh_general_parameters, colour_origin) == 20);
static_assert(offsetof(draw_mesh_general_parameters, camera) == 28);
struct draw_mesh_wide_parameters {
    uint2 size;
    uint corner_origin;
    uint points_origin;
    uint points_size;
    uint2 colour_origin;
    float4x4 camera;
    std::uint64_t corner_data_address;
    std::uint64_t points_data_address;
};
static_assert(offsetof(draw_mesh_wide_parameters, size) == 0);
static_assert(offsetof(draw_mesh_wide_parameters, corner_origin) == 8);
static_assert(offsetof(draw_mesh_wide_parameters, points_origin) == 12);
static_assert(offsetof(draw_mesh_wide_parameters, points_size) == 16);
static_assert(offsetof(draw_mesh_wide_parameters, colour_origin) == 20);
static_assert(offsetof(draw_mesh_wide_parameters, camera) == 28);
static_assert(offsetof(draw_mesh_wide_parameters, corner_data_address) == 96);
static_assert(offsetof(draw_mesh_wide_parameters, points_data_address) == 104);
}  // namespace

extern const glift::Kernel draw_mesh_kernel;

void draw_mesh(const glift::Commands& commands, const glift::Range<Corners>& corner, const glift::Range<Points>& points,
    float4x4 camera, const glift::Range<Colour>& colour, const glift::Range<Depth>& depth) {
    glift::DrawIteration iteration(draw_mesh_kernel);
    iteration.corners("corner", corner);
    iteration.any("points", points);
    iteration.colour("colour", colour, colour->data());
    iteration.depth("depth", depth, depth->data());
    const glift::Memory memories[] = {corner->data(), points->data()};
    if (commands.needs_wide(draw_mesh_kernel, memories, iteration.size())) {
        const draw_mesh_wide_parameters parameters = {
            .size = iteration.counts(),
            .corner_origin = corner.origin(),
            .points_origin = points.origin(),
            .points_size = points.size(),
            .colour_origin = colour.origin(),
            .camera = camera,
            .corner_data_address = 0u,
            .points_data_address = 0u,
        };
        iteration.count(points, offsetof(draw_mesh_wide_parameters, points_size));
        commands.dispatch(draw_mesh_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(draw_mesh_wide_parameters, size)}), .targets = iteration.targets()});
    } else if (iteration.is_whole()) {
        const draw_mesh_direct_parameters parameters = {
            .points_extent = points->extent(),
            .camera = camera,
        };
        commands.dispatch(draw_mesh_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .targets = iteration.targets()});
    } else {
        const draw_mesh_general_parameters parameters = {
            .size = iteration.counts(),
            .corner_origin = corner.origin(),
            .points_origin = points.origin(),
            .points_size = points.size(),
            .colour_origin = colour.origin(),
            .camera = camera,
        };
        iteration.count(points, offsetof(draw_mesh_general_parameters, points_size));
        commands.dispatch(draw_mesh_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(draw_mesh_general_parameters, size)}),
            .targets = iteration.targets()});
    }
}

namespace {
struct draw_marks_general_parameters {
    uint2 size;
    uint corner_origin;
    uint mark_origin;
    uint2 image_origin;
};
static_assert(offsetof(draw_marks_general_parameters, size) == 0);
static_assert(offsetof(draw_marks_general_parameters, corner_origin) == 8);
static_assert(offsetof(draw_marks_general_parameters, mark_origin) == 12);
static_assert(offsetof(draw_marks_general_parameters, image_origin) == 16);
struct draw_marks_wide_parameters {
    uint2 size;
    uint corner_origin;
    uint mark_origin;
    uint2 image_origin;
    std::uint64_t corner_data_address;
    std::uint64_t mark_data_address;
};
static_assert(offsetof(draw_marks_wide_parameters, size) == 0);
static_assert(offsetof(draw_marks_wide_parameters, corner_origin) == 8);
static_assert(offsetof(draw_marks_wide_parameters, mark_origin) == 12);
static_assert(offsetof(draw_marks_wide_parameters, image_origin) == 16);
static_assert(offsetof(draw_marks_wide_parameters, corner_data_address) == 24);
static_assert(offsetof(draw_marks_wide_parameters, mark_data_address) == 32);
}  // namespace

extern const glift::Kernel draw_marks_kernel;

void draw_marks(const glift::Commands& commands, const glift::Range<Points>& corner, const glift::Range<Points>& mark,
    const glift::Range<Colour>& image, const glift::Range<Depth>& depth) {
    glift::DrawIteration iteration(draw_marks_kernel);
    iteration.corners("corner", corner);
    iteration.instances("mark", mark);
    iteration.colour("image", image, image->data());
    iteration.depth("depth", depth, depth->data());
    const glift::Memory memories[] = {corner->data(), mark->data()};
    if (commands.needs_wide(draw_marks_kernel, memories, iteration.size(), iteration.sharing())) {
        const draw_marks_wide_parameters parameters = {
            .size = iteration.counts(),
            .corner_origin = corner.origin(),
            .mark_origin = mark.origin(),
            .image_origin = image.origin(),
            .corner_data_address = 0u,
            .mark_data_address = 0u,
        };
        commands.dispatch(draw_marks_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(draw_marks_wide_parameters, size)}),
            .targets = iteration.targets()});
    } else if (iteration.is_whole() && iteration.sharing() != glift::Sharing::one_place) {
        commands.dispatch(draw_marks_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = {}, .size = iteration.size(),
            .targets = iteration.targets()});
    } else {
        const draw_marks_general_parameters parameters = {
            .size = iteration.counts(),
            .corner_origin = corner.origin(),
            .mark_origin = mark.origin(),
            .image_origin = image.origin(),
        };
        commands.dispatch(draw_marks_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(draw_marks_general_parameters, size)}),
            .targets = iteration.targets()});
    }
}

namespace {
struct even_direct_parameters {
    float factor;
    float2 factor_2;
};
static_assert(offsetof(even_direct_parameters, factor) == 0);
static_assert(offsetof(even_direct_parameters, factor_2) == 4);
struct even_general_parameters {
    uint2 size;
    uint corner_origin;
    uint2 image_origin;
    float factor;
    float2 factor_2;
};
static_assert(offsetof(even_general_parameters, size) == 0);
static_assert(offsetof(even_general_parameters, corner_origin) == 8);
static_assert(offsetof(even_general_parameters, image_origin) == 12);
static_assert(offsetof(even_general_parameters, factor) == 20);
static_assert(offsetof(even_general_parameters, factor_2) == 24);
struct even_wide_parameters {
    uint2 size;
    uint corner_origin;
    uint2 image_origin;
    float factor;
    float2 factor_2;
    std::uint64_t corner_data_address;
};
static_assert(offsetof(even_wide_parameters, size) == 0);
static_assert(offsetof(even_wide_parameters, corner_origin) == 8);
static_assert(offsetof(even_wide_parameters, image_origin) == 12);
static_assert(offsetof(even_wide_parameters, factor) == 20);
static_assert(offsetof(even_wide_parameters, factor_2) == 24);
static_assert(offsetof(even_wide_parameters, corner_data_address) == 32);
}  // namespace

extern const glift::Kernel even_kernel;

void even(const glift::Commands& commands, const glift::Range<Points>& corner, float factor,
    const glift::Range<Colour>& image) {
    glift::DrawIteration iteration(even_kernel);
    iteration.corners("corner", corner);
    iteration.colour("image", image, image->data());
    const glift::Memory memories[] = {corner->data()};
    if (commands.needs_wide(even_kernel, memories, iteration.size())) {
        const even_wide_parameters parameters = {
            .size = iteration.counts(),
            .corner_origin = corner.origin(),
            .image_origin = image.origin(),
            .factor = factor,
            .factor_2 = float2(factor, 2.0f),
            .corner_data_address = 0u,
        };
        commands.dispatch(even_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(even_wide_parameters, size)}), .targets = iteration.targets()});
    } else if (iteration.is_whole()) {
        const even_direct_parameters parameters = {
            .factor = factor,
            .factor_2 = float2(factor, 2.0f),
        };
        commands.dispatch(even_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .targets = iteration.targets()});
    } else {
        const even_general_parameters parameters = {
            .size = iteration.counts(),
            .corner_origin = corner.origin(),
            .image_origin = image.origin(),
            .factor = factor,
            .factor_2 = float2(factor, 2.0f),
        };
        commands.dispatch(even_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(even_general_parameters, size)}), .targets = iteration.targets()});
    }
}

// draws.glift:83: frame
void frame(const glift::Commands& commands, const Corners& corners, const Points& points, float4x4 camera,
    const Points& marks, const Corners& number, const Colour& image) {
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
