// Made by gliftc from draws.glift. Changes are lost when it is made again.
#include "draws.glift.types.hpp"

#include <glift/drawing.h>
#include <glift/host/fragments.h>
#include <glift/host/math.h>
#include <glift/host/parallel.h>
#include <glift/kernel.h>

namespace draws {

using namespace glift::types;

// draws.glift:14: draw_mesh

namespace {
struct draw_mesh_general_parameters {
    uint2 size;
    uint corner_origin;
    uint points_origin;
    uint points_size;
    uint2 colour_origin;
    float4x4 camera;
    std::uint64_t corner_data_address;
    std::uint64_t points_data_address;
};
static_assert(sizeof(draw_mesh_general_parameters) == 112);

GLIFT_HOST_KERNEL
static void draw_mesh_general_vertex(const void* pointer, std::uint64_t first, std::uint32_t count,
    [[maybe_unused]] std::uint32_t instance, float* corners) {
    [[maybe_unused]] const auto& call = *static_cast<const glift::HostCall*>(pointer);
    const auto& parameters = *static_cast<const draw_mesh_general_parameters*>(call.parameters);
    const uint corner_origin = parameters.corner_origin;
    const uint points_origin = parameters.points_origin;
    const uint points_size = parameters.points_size;
    const float4x4 camera = parameters.camera;
    const uint* corner_data = glift::host::elements<const uint>(call.memories[0]);
    const float3* points_data = glift::host::elements<const float3>(call.memories[1]);
    for (std::uint32_t i = 0; i < count; ++i) {
        [[maybe_unused]] const uint corner = static_cast<uint>(first) + i;
        float4 place{};
        float3 world{};
        const uint2 address_2 = uint2(corner, instance);
        // draws.glift:20
        const uint corner_address = corner_origin + address_2.x;
        const uint points_address = corner_data[corner_address];
        const uint points_virtual = points_origin + points_address;
        const bool points_value_inside = points_address < points_size;
        const float3 points_value = points_data[points_value_inside ? points_virtual : 0u];
        world = points_value_inside ? points_value : float3(0.0f);
        // draws.glift:21
        place = camera * float4(world, 1.0f);
        corners = glift::host::put(corners, place);
        corners = glift::host::put(corners, world);
    }
}

GLIFT_HOST_KERNEL
static void draw_mesh_general_fragment(const void* pointer, const glift::host::Fragments& fragments) {
    [[maybe_unused]] const auto& call = *static_cast<const glift::HostCall*>(pointer);
    float4 colour[glift::host::block_pixels];
    [[maybe_unused]] std::uint64_t drawn = fragments.covered;
    const std::uint64_t running = glift::host::quads_of(drawn);
    float3 derived[glift::host::block_pixels];
    for (std::uint64_t left = running; left != 0; left &= left - 1) {
        [[maybe_unused]] const std::uint32_t pixel = glift::host::first_of(left);
        const float3 world = glift::host::smooth<float3>(fragments, pixel, 0);
        // draws.glift:25
        derived[pixel] = world;
    }
    // All pixels of each quad have computed the value whose derivative follows.
    for (std::uint64_t left = running & drawn; left != 0; left &= left - 1) {
        [[maybe_unused]] const std::uint32_t pixel = glift::host::first_of(left);
        const float3 v = glift::cross(glift::host::dFdx(derived, pixel), glift::host::dFdy(derived, pixel));
        const float3 normal = v * float3(1.0f / glift::sqrt(glift::dot(v, v)));
        // draws.glift:26
        if (normal.z < 0.0f) {
            // draws.glift:27
            drawn &= ~(std::uint64_t{1} << pixel);
            continue;
        }
        // draws.glift:29
        colour[pixel] = float4(float3(0.2f) + 0.8f * normal.z, 1.0f);
    }
    drawn = fragments.test(drawn);
    glift::host::draw_colour<glift::Format::rgba8,
        glift::Blend::replace>(call.targets->colours[0], fragments, drawn, colour);
}

static void draw_mesh_general(const glift::HostCall& call) {
    const glift::HostTargets& targets = *call.targets;
    glift::host::Draw draw;
    draw.body = &call;
    draw.vertex = draw_mesh_general_vertex;
    draw.fragment = draw_mesh_general_fragment;
    draw.corners = call.size[0];
    draw.instances = call.size[1];
    draw.varyings = 3;
    draw.viewport = targets.extent;
    draw.framebuffer = targets.origin;
    draw.cull = glift::Cull::back;
    draw.has_smooth = true;
    draw.depth = {reinterpret_cast<float*>(targets.depth.first), targets.depth.row / sizeof(float),
        glift::DepthTest::less, true, false};
    glift::host::draw(draw);
}

const glift::Binding draw_mesh_bindings[] = {
    {.name = "corner.data", .address_offset = 96, .element_bytes = sizeof(uint), .reach = glift::Reach::element},
    {.name = "points.data", .address_offset = 104, .element_bytes = sizeof(float3), .parameter = 1,
        .reach = glift::Reach::range},
};
constexpr glift::Parameter draw_mesh_parameters[] = {{"points_extent", 0, 4}, {"camera", 4, 64}};
const glift::ColourTarget draw_mesh_colours[] = {
    {.name = "colour", .format = glift::Format::rgba8},
};
const glift::Drawing draw_mesh_drawing = {.topology = glift::Topology::triangles, .cull = glift::Cull::back,
    .colours = draw_mesh_colours, .depth = "depth", .depth_test = glift::DepthTest::less};
}  // namespace

extern const glift::Kernel draw_mesh_kernel;
const glift::Kernel draw_mesh_kernel = {
    .name = "draw_mesh",
    .file = "draws.glift",
    .line = 14,
    .rank = 2,
    .group = {1, 1, 1},
    .loop_rounds = 0,
    .bindings = draw_mesh_bindings,
    .direct = {.parameter_bytes = 68, .push_constants = true},
    .general = {.host = &draw_mesh_general, .parameter_bytes = 112, .uniform_buffer = true},
    .parameters = draw_mesh_parameters,
    .drawing = &draw_mesh_drawing,
};

// draws.glift:34: draw_marks

namespace {
struct draw_marks_general_parameters {
    uint2 size;
    uint corner_origin;
    uint mark_origin;
    uint2 image_origin;
    std::uint64_t corner_data_address;
    std::uint64_t mark_data_address;
};
static_assert(sizeof(draw_marks_general_parameters) == 40);

GLIFT_HOST_KERNEL
static void draw_marks_general_vertex(const void* pointer, std::uint64_t first, std::uint32_t count,
    [[maybe_unused]] std::uint32_t instance, float* corners) {
    [[maybe_unused]] const auto& call = *static_cast<const glift::HostCall*>(pointer);
    const auto& parameters = *static_cast<const draw_marks_general_parameters*>(call.parameters);
    const uint corner_origin = parameters.corner_origin;
    const uint mark_origin = parameters.mark_origin;
    const float3* corner_data = glift::host::elements<const float3>(call.memories[0]);
    const float3* mark_data = glift::host::elements<const float3>(call.memories[1]);
    for (std::uint32_t i = 0; i < count; ++i) {
        [[maybe_unused]] const uint corner = static_cast<uint>(first) + i;
        float4 place{};
        float2 inside_2{};
        uint kind{};
        const uint2 address_2 = uint2(corner, instance);
        // draws.glift:40
        const uint corner_address = corner_origin + address_2.x;
        // draws.glift:41
        const uint mark_address = mark_origin + address_2.y;
        // draws.glift:40
        const float2 value = corner_data[corner_address].xy();
        inside_2 = value;
        // draws.glift:41
        const float3 mark_data_value = mark_data[mark_address];
        kind = glift::convert<uint>(mark_data_value.z);
        // draws.glift:42
        place = float4(mark_data_value.xy() + 0.125f * value, 0.0f, 1.0f);
        corners = glift::host::put(corners, place);
        corners = glift::host::put(corners, inside_2);
        corners = glift::host::put(corners, kind);
    }
}

GLIFT_HOST_KERNEL
static void draw_marks_general_fragment(const void* pointer, const glift::host::Fragments& fragments) {
    [[maybe_unused]] const auto& call = *static_cast<const glift::HostCall*>(pointer);
    const uint kind = glift::host::flat<uint>(fragments, 2);
    float4 image[glift::host::block_pixels];
    [[maybe_unused]] std::uint64_t drawn = fragments.covered;
    const std::uint64_t running = drawn;
    for (std::uint64_t left = running; left != 0; left &= left - 1) {
        [[maybe_unused]] const std::uint32_t pixel = glift::host::first_of(left);
        const float2 inside_2 = glift::host::linear<float2>(fragments, pixel, 0);
        // draws.glift:45
        image[pixel] = float4(inside_2, float(kind), 0.5f) * (fragments.is_front ? 1.0f : 0.5f);
    }
    glift::host::draw_colour<glift::Format::rgba8,
        glift::Blend::over>(call.targets->colours[0], fragments, drawn, image);
}

static void draw_marks_general(const glift::HostCall& call) {
    const glift::HostTargets& targets = *call.targets;
    glift::host::Draw draw;
    draw.body = &call;
    draw.vertex = draw_marks_general_vertex;
    draw.fragment = draw_marks_general_fragment;
    draw.corners = call.size[0];
    draw.instances = call.size[1];
    draw.varyings = 3;
    draw.viewport = targets.extent;
    draw.framebuffer = targets.origin;
    draw.depth = {reinterpret_cast<float*>(targets.depth.first), targets.depth.row / sizeof(float),
        glift::DepthTest::greater, false, true};
    glift::host::draw(draw);
}

const glift::Binding draw_marks_bindings[] = {
    {.name = "corner.data", .address_offset = 24, .element_bytes = sizeof(float3), .reach = glift::Reach::element},
    {.name = "mark.data", .address_offset = 32, .element_bytes = sizeof(float3), .parameter = 1,
        .reach = glift::Reach::element},
};
const glift::ColourTarget draw_marks_colours[] = {
    {.name = "image", .format = glift::Format::rgba8, .blend = glift::Blend::over},
};
const glift::Drawing draw_marks_drawing = {.topology = glift::Topology::triangles, .cull = glift::Cull::none,
    .colours = draw_marks_colours, .depth = "depth", .depth_test = glift::DepthTest::greater, .writes_depth = false};
}  // namespace

extern const glift::Kernel draw_marks_kernel;
const glift::Kernel draw_marks_kernel = {
    .name = "draw_marks",
    .file = "draws.glift",
    .line = 34,
    .rank = 2,
    .group = {1, 1, 1},
    .loop_rounds = 0,
    .bindings = draw_marks_bindings,
    .direct = {.push_constants = true},
    .general = {.host = &draw_marks_general, .parameter_bytes = 40, .uniform_buffer = true},
    .drawing = &draw_marks_drawing,
};

// draws.glift:67: even

namespace {
struct even_general_parameters {
    uint2 size;
    uint corner_origin;
    uint2 image_origin;
    float factor;
    float2 factor_2;
    std::uint64_t corner_data_address;
};
static_assert(sizeof(even_general_parameters) == 40);

GLIFT_HOST_KERNEL
static void even_general_vertex(const void* pointer, std::uint64_t first, std::uint32_t count,
    [[maybe_unused]] std::uint32_t instance, float* corners) {
    [[maybe_unused]] const auto& call = *static_cast<const glift::HostCall*>(pointer);
    const auto& parameters = *static_cast<const even_general_parameters*>(call.parameters);
    const uint corner_origin = parameters.corner_origin;
    const float3* corner_data = glift::host::elements<const float3>(call.memories[0]);
    for (std::uint32_t i = 0; i < count; ++i) {
        [[maybe_unused]] const uint corner = static_cast<uint>(first) + i;
        float4 place{};
        const uint2 address_2 = uint2(corner, instance);
        // draws.glift:68
        const uint corner_address = corner_origin + address_2.x;
        place = float4(corner_data[corner_address], 1.0f);
        corners = glift::host::put(corners, place);
    }
}

GLIFT_HOST_KERNEL
static void even_general_fragment(const void* pointer, const glift::host::Fragments& fragments) {
    [[maybe_unused]] const auto& call = *static_cast<const glift::HostCall*>(pointer);
    const auto& parameters = *static_cast<const even_general_parameters*>(call.parameters);
    const float factor = parameters.factor;
    const float2 factor_2 = parameters.factor_2;
    float4 image[glift::host::block_pixels];
    [[maybe_unused]] std::uint64_t drawn = fragments.covered;
    const std::uint64_t running = glift::host::quads_of(drawn);
    float derived[glift::host::block_pixels];
    float derived_2[glift::host::block_pixels];
    float2 derived_3[glift::host::block_pixels];
    for (std::uint64_t left = running; left != 0; left &= left - 1) {
        [[maybe_unused]] const std::uint32_t pixel = glift::host::first_of(left);
        // draws.glift:70
        derived[pixel] = 3.0f;
        derived_2[pixel] = factor;
        derived_3[pixel] = factor_2;
    }
    // All pixels of each quad have computed the value whose derivative follows.
    for (std::uint64_t left = running & drawn; left != 0; left &= left - 1) {
        [[maybe_unused]] const std::uint32_t pixel = glift::host::first_of(left);
        image[pixel] = float4(glift::host::dFdx(derived, pixel), glift::host::dFdy(derived_2, pixel),
            glift::host::fwidth(derived_3, pixel));
    }
    glift::host::draw_colour<glift::Format::rgba8,
        glift::Blend::replace>(call.targets->colours[0], fragments, drawn, image);
}

static void even_general(const glift::HostCall& call) {
    const glift::HostTargets& targets = *call.targets;
    glift::host::Draw draw;
    draw.body = &call;
    draw.vertex = even_general_vertex;
    draw.fragment = even_general_fragment;
    draw.corners = call.size[0];
    draw.instances = call.size[1];
    draw.viewport = targets.extent;
    draw.framebuffer = targets.origin;
    glift::host::draw(draw);
}

const glift::Binding even_bindings[] = {
    {.name = "corner.data", .address_offset = 32, .element_bytes = sizeof(float3), .reach = glift::Reach::element},
};
constexpr glift::Parameter even_parameters[] = {{"factor", 0, 4}, {"factor_2", 4, 8}};
const glift::ColourTarget even_colours[] = {
    {.name = "image", .format = glift::Format::rgba8},
};
const glift::Drawing even_drawing = {.topology = glift::Topology::triangles, .cull = glift::Cull::none,
    .colours = even_colours};
}  // namespace

extern const glift::Kernel even_kernel;
const glift::Kernel even_kernel = {
    .name = "even",
    .file = "draws.glift",
    .line = 67,
    .rank = 2,
    .group = {1, 1, 1},
    .loop_rounds = 0,
    .bindings = even_bindings,
    .direct = {.parameter_bytes = 12, .push_constants = true},
    .general = {.host = &even_general, .parameter_bytes = 40, .uniform_buffer = true},
    .parameters = even_parameters,
    .drawing = &even_drawing,
};

}  // namespace draws

