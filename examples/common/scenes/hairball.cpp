#include "random.h"
#include "scenes.h"

#include "examples/common/shapes.h"

#include <glift/host/math.h>

#include <cmath>

namespace scenes {

namespace {

using glift::float3;

constexpr unsigned hairs = 4000, segments = 12;

float3 direction(Random& random) {
    for (;;) {
        const float3 d = random.inside(float3(-1), float3(1));
        const float squared = glift::dot(d, d);
        if (squared > 0.01f && squared < 1) return d / std::sqrt(squared);
    }
}

/// A ribbon that curls outwards from the ball and hangs down.
void add_hair(mesh::Mesh& mesh, const float3& centre, Random& random, float time) {
    const float3 out = direction(random);
    const float curled = random.between(0.1f, 0.5f);
    const float3 curl = direction(random) * curled;
    const float3 side = glift::normalize(glift::cross(out, direction(random)));
    const float length = random.between(0.45f, 0.75f), phase = random.between(0, 6),
                shade = random.between(0.25f, 0.6f);
    const float3 colour(shade, shade * 0.65f, shade * 0.35f);
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (unsigned i = 0; i <= segments; ++i) {
        const float t = static_cast<float>(i) / segments;
        const float3 sway = side * (0.06f * t * t * std::sin(1.7f * time + phase));
        const float3 place =
            centre + out * (0.4f + length * t) + curl * (t * t * length) + sway - float3(0, 0.35f * t * t, 0);
        const float3 half = side * (0.004f * (1 - 0.8f * t));
        for (const float3& point : {place - half, place + half}) {
            mesh.points.push_back(point);
            mesh.colours.push_back(colour);
        }
    }
    for (std::uint32_t i = first; i < first + 2 * segments; i += 2)
        for (const std::uint32_t corner : {i, i + 1, i + 2, i + 2, i + 1, i + 3}) mesh.corners.push_back(corner);
}

}  // namespace

Scene hairball(float time) {
    Scene scene;
    Random random(1);
    const float3 centre(0, 1.3f, 0);
    mesh::add_sphere(scene.mesh, centre, 0.4f, 24, float3(0.3f, 0.2f, 0.12f));
    for (unsigned i = 0; i < hairs; ++i) add_hair(scene.mesh, centre, random, time);
    mesh::add_box(scene.mesh, float3(-3, -0.1f, -2), float3(3, 0, 3), float3(0.75f, 0.73f, 0.7f));
    mesh::add_box(scene.mesh, float3(-3, 0, -2.1f), float3(3, 4, -2), float3(0.8f, 0.78f, 0.74f));
    scene.view = {float3(2.2f, 2.0f, 4.6f), float3(0, 1.2f, -0.4f), float3(0, 1, 0), 0.75f, 0.1f, 30};
    scene.light = {float3(2.6f, 5.0f, 5.2f), float3(0, 1.0f, -0.5f), float3(0, 1, 0), 0.8f, 0.5f, 14};
    scene.light_half_size = 4;
    return scene;
}

}  // namespace scenes
