#include "draw_kernels.h"

#include "draw_fragment.h"
#include "draw_vertex.h"

#include <glift/host/parallel.h>
#include <glift/host/raster.h>

#include <bit>

namespace kernels {

namespace {

using glift::Access;
using glift::host::Fragments;

struct Body {
    const glift::HostCall& call;
    glift::Blend blend;
    const DrawParameters& parameters() const { return *static_cast<const DrawParameters*>(call.parameters); }
};

void run_vertices(const void* pointer, std::uint64_t first, std::uint32_t count, std::uint32_t instance, float* out) {
    const Body& body = *static_cast<const Body*>(pointer);
    const auto* corners = reinterpret_cast<const Corner*>(body.call.memories[0].data);
    for (const Corner& corner : std::span(corners + first, count)) {
        std::copy_n(corner.place, 4, out);
        out[0] += body.parameters().shift * static_cast<float>(instance) * corner.place[3];
        std::copy_n(corner.colour, 4, out + 4);
        out += 8;
    }
}

void run_fragments(const void* pointer, const Fragments& fragments) {
    const Body& body = *static_cast<const Body*>(pointer);
    const glift::HostTargets::Texels& image = body.call.targets->colours[0];
    for (std::uint64_t left = fragments.covered; left != 0; left &= left - 1) {
        const int pixel = std::countr_zero(left), x = fragments.first.x + pixel % 8, y = fragments.first.y + pixel / 8;
        float colour[4];
        for (int i = 0; i < 4; ++i) {
            const float c = fragments.corner[0][i];
            colour[i] = c + fragments.smooth1[pixel] * (fragments.corner[1][i] - c) +
                        fragments.smooth2[pixel] * (fragments.corner[2][i] - c);
        }
        auto* texel = reinterpret_cast<float*>(image.first + static_cast<std::size_t>(y) * image.row) + 4 * x;
        const float kept = body.blend == glift::Blend::over ? 1.0f - colour[3] : 0.0f;
        for (int i = 0; i < 4; ++i) texel[i] = colour[i] + kept * texel[i];
        auto& count = *reinterpret_cast<std::uint32_t*>(body.call.memories[1].data);
        std::atomic_ref(count).fetch_add(1);
    }
}

template <glift::Blend blend, glift::Cull cull> void host_draw(const glift::HostCall& call) {
    const Body body{call, blend};
    const glift::HostTargets& targets = *call.targets;
    glift::host::Draw draw;
    draw.body = &body;
    draw.vertex = run_vertices;
    draw.fragment = run_fragments;
    draw.corners = call.size[0];
    draw.instances = call.size[1];
    draw.varyings = 4;
    draw.viewport = targets.extent;
    draw.framebuffer = targets.origin;
    draw.cull = cull;
    draw.has_smooth = true;
    if (targets.depth.first)
        draw.depth = {reinterpret_cast<float*>(targets.depth.first), targets.depth.row / sizeof(float)};
    glift::host::draw(draw);
}

const glift::Binding bindings[] = {
    {.name = "corners.data",
     .kind = glift::MemoryKind::buffer,
     .access = Access::read,
     .address_offset = 16,
     .element_bytes = 32},
    {.name = "counts.data", .kind = glift::MemoryKind::buffer, .access = Access::read_write, .address_offset = 24}};
const glift::ColourTarget replaced[] = {{"image", glift::Format::rgba32f}};
const glift::ColourTarget blended[] = {{"image", glift::Format::rgba32f, glift::Blend::over}};
const glift::Drawing replacing = {.colours = replaced, .depth = "depth"};
const glift::Drawing over = {.colours = blended};
const glift::Drawing culled = {.cull = glift::Cull::back, .colours = replaced, .depth = "depth"};

constexpr glift::Kernel kernel(const char* name, const glift::Drawing& drawing, void (*host)(const glift::HostCall&)) {
    const glift::Form form = {
        .spirv = draw_vertex, .fragment = draw_fragment, .host = host, .parameter_bytes = sizeof(DrawParameters)};
    return {.name = name,
            .file = "draw.glift",
            .line = 9,
            .rank = 2,
            .group = {1, 1, 1},
            .loop_rounds = 0,
            .bindings = bindings,
            .general = form,
            .drawing = &drawing};
}

}  // namespace

const glift::Kernel draw_replacing =
    kernel("draw_replacing", replacing, host_draw<glift::Blend::replace, glift::Cull::none>);
const glift::Kernel draw_over = kernel("draw_over", over, host_draw<glift::Blend::over, glift::Cull::none>);
const glift::Kernel draw_culled = kernel("draw_culled", culled, host_draw<glift::Blend::replace, glift::Cull::back>);

}  // namespace kernels
