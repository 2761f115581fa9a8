#include "render.h"

#include <glift/host/math.h>
#include <glift/host/raster.h>

#include <bit>
#include <cmath>
#include <numbers>

namespace render {

namespace {

using glift::float3;
using glift::float4;
using glift::float4x4;
using glift::uint2;
using glift::host::Fragments;

/// Numbers of a corner after its place: cuts, then what varies.
constexpr unsigned cut_count = 2, colour_at = 0, place_at = 3, varyings = 6;

struct Drawing {
    const scenes::Scene& scene;
    float4x4 projection;
    Cuts cuts;
    float3 towards_light;
    picture::Picture picture;
};

float4 projected(const float4x4& m, const float3& p) { return m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3]; }

void run_vertices(const void* body, std::uint64_t first, std::uint32_t count, std::uint32_t, float* out) {
    const Drawing& drawing = *static_cast<const Drawing*>(body);
    const mesh::Mesh& mesh = drawing.scene.mesh;
    for (std::uint64_t i = first; i < first + count; ++i) {
        const std::uint32_t corner = mesh.corners[i];
        const float3 &place = mesh.points[corner], &colour = mesh.colours[corner];
        const float4 clip = projected(drawing.projection, place);
        for (const float number : {clip.x, clip.y, clip.z, clip.w, clip.w - drawing.cuts.near,
                                   drawing.cuts.far - clip.w, colour.x, colour.y, colour.z, place.x, place.y, place.z})
            *out++ = number;
    }
}

float3 vector_at(const float* varying) { return float3(varying[0], varying[1], varying[2]); }

float light_on(const Drawing& drawing, const Fragments& fragments) {
    const float3 a = vector_at(fragments.corner[0] + place_at), b = vector_at(fragments.corner[1] + place_at),
                 c = vector_at(fragments.corner[2] + place_at);
    float3 normal = glift::cross(b - a, c - a);
    const float length = glift::length(normal);
    if (length > 0) normal = normal * ((fragments.is_front ? 1.0f : -1.0f) / length);
    constexpr float sky = 0.35f, sun = 0.75f;
    return sky * (0.75f + 0.25f * normal.y) + sun * std::max(0.0f, glift::dot(normal, drawing.towards_light));
}

void run_fragments(const void* body, const Fragments& fragments) {
    // Tiles have pixels of their own: fragments may write the picture from any thread.
    Drawing& drawing = *static_cast<Drawing*>(const_cast<void*>(body));
    const float light = light_on(drawing, fragments);
    const float3 a = vector_at(fragments.corner[0] + colour_at), b = vector_at(fragments.corner[1] + colour_at),
                 c = vector_at(fragments.corner[2] + colour_at);
    for (std::uint64_t left = fragments.covered; left != 0; left &= left - 1) {
        const int pixel = std::countr_zero(left);
        const auto x = static_cast<std::size_t>(fragments.first.x + pixel % 8),
                   y = static_cast<std::size_t>(fragments.first.y + pixel / 8);
        const float3 colour = (a + (b - a) * fragments.smooth1[pixel] + (c - a) * fragments.smooth2[pixel]) * light;
        const std::size_t at = y * drawing.picture.width + x;
        drawing.picture.pixels[at] = float4(colour.x, colour.y, colour.z, 1);
        drawing.picture.depth[at] = 1 / fragments.w[pixel];
    }
}

/// Moves the eye over the lens; what lies in focus stays where it is in the picture.
float4x4 seen_from(float4x4 projection, const LensPoint& point, float scale_x, float scale_y) {
    for (unsigned column = 0; column < 4; ++column) {
        const float along = projection[column][3];  // w: the distance along the axis
        const float offset = column == 3 ? 1.0f : 0.0f;
        projection[column][0] += scale_x * point.right * (along / point.focus - offset);
        projection[column][1] -= scale_y * point.up * (along / point.focus - offset);
    }
    return projection;
}

}  // namespace

picture::Picture drawn(const scenes::Scene& scene, std::uint32_t width, std::uint32_t height, const Cuts& cuts,
                       const LensPoint& point) {
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    const float scale = 1 / std::tan(scene.view.height_angle / 2);
    const std::size_t count = std::size_t{width} * height;
    Drawing drawing{scene,
                    seen_from(camera::projection_of(scene.view, aspect), point, scale / aspect, scale),
                    cuts,
                    glift::normalize(scene.light.eye - scene.light.target),
                    {width, height, {}, {}}};
    drawing.picture.pixels.assign(count, float4(scene.sky.x, scene.sky.y, scene.sky.z, 0));
    drawing.picture.depth.assign(count, scene.view.far);
    std::vector<float> depth(count, 1.0f);
    glift::host::Draw draw;
    draw.body = &drawing;
    draw.vertex = run_vertices;
    draw.fragment = run_fragments;
    draw.corners = scene.mesh.corners.size();
    draw.clip_distances = cut_count;
    draw.varyings = varyings;
    draw.viewport = uint2(width, height);
    draw.has_smooth = true;
    draw.depth = {depth.data(), width};
    glift::host::draw(draw);
    return std::move(drawing.picture);
}

picture::Picture before_sky(picture::Picture picture) {
    for (float4& pixel : picture.pixels) pixel.w = 1;  // where nothing is the colour is the sky's already
    return picture;
}

picture::Picture through_lens(const scenes::Scene& scene, std::uint32_t width, std::uint32_t height, float diameter,
                              float focus, unsigned samples) {
    picture::Picture mean{width, height, std::vector<float4>(std::size_t{width} * height), {}};
    for (unsigned i = 0; i < samples; ++i) {
        // Vogel's spiral: places of equal shares of the disc.
        const float radius = 0.5f * diameter * std::sqrt((static_cast<float>(i) + 0.5f) / static_cast<float>(samples));
        const float angle = static_cast<float>(i) * std::numbers::pi_v<float> * (3 - std::sqrt(5.0f));
        const LensPoint point{radius * std::cos(angle), radius * std::sin(angle), focus};
        const picture::Picture one = before_sky(drawn(scene, width, height, {}, point));
        for (std::size_t k = 0; k < mean.pixels.size(); ++k)
            mean.pixels[k] = mean.pixels[k] + one.pixels[k] * (1 / static_cast<float>(samples));
    }
    return mean;
}

}  // namespace render
