#include "random.h"
#include "scenes.h"

#include "examples/common/shapes.h"

#include <glift/host/math.h>

#include <cmath>

namespace scenes {

namespace {

using glift::float3;

/// A point moved by the wind, the more the higher it is.
float3 in_wind(const float3& place, float time) {
    const float amount = 0.02f * place.y * place.y;
    return place + float3(amount * std::sin(1.3f * time + place.z), 0, 0.5f * amount * std::sin(1.7f * time + place.x));
}

void add_leaf(mesh::Mesh& mesh, const float3& at, Random& random, float time) {
    const float3 u = random.inside(float3(-1), float3(1));
    const float3 v = random.inside(float3(-1), float3(1));
    const float green = random.between(0.3f, 0.5f);
    const float red = random.between(0.08f, 0.22f);
    const float3 colour(red, green, 0.06f);
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const float3& corner : {u * -0.06f, u * 0.06f, v * 0.09f}) {
        mesh.points.push_back(in_wind(at + corner, time));
        mesh.colours.push_back(colour);
    }
    for (const std::uint32_t corner : {0u, 1u, 2u}) mesh.corners.push_back(first + corner);
}

/// Adds a branch with three branches at its end, and so on for `depth` generations; branches of the last generation
/// have leaves along them instead.
void add_branch(mesh::Mesh& mesh, const float3& from, const float3& direction, float length, float radius, int depth,
                Random& random, float time) {
    const float3 to = from + direction * length;
    mesh::add_rod(mesh, in_wind(from, time), in_wind(to, time), radius, radius * 0.7f, depth > 2 ? 8 : 5,
                  float3(0.24f, 0.16f, 0.1f));
    if (depth == 0) {
        for (int i = 0; i < 12; ++i) {
            const float3 beside = random.inside(float3(-0.15f), float3(0.15f));
            const float along = length * random.between(0, 1.4f);
            add_leaf(mesh, from + direction * along + beside, random, time);
        }
        return;
    }
    for (int i = 0; i < 3; ++i) {
        const float3 aside = random.inside(float3(-0.8f, -0.1f, -0.8f), float3(0.8f, 0.5f, 0.8f));
        const float next_length = length * random.between(0.65f, 0.8f);
        add_branch(mesh, to, glift::normalize(direction + aside), next_length, radius * 0.62f, depth - 1, random, time);
    }
}

}  // namespace

Scene trees(float time) {
    Scene scene;
    Random random(33);
    const auto lawn = [](float u, float v) {
        return float3(24 * u - 12, 0.15f * std::sin(5 * u) * std::cos(4 * v) - 0.1f, 24 * v - 12);
    };
    const auto grass = [](float u, float v) {
        const float grain = 0.5f + 0.5f * std::sin(300 * u) * std::sin(290 * v);
        return float3(0.14f, 0.28f + 0.08f * grain, 0.07f);
    };
    mesh::add_sheet(scene.mesh, 60, 60, lawn, grass);
    for (int i = 0; i < 7; ++i) {
        const float angle = 0.9f * static_cast<float>(i) + 0.4f, far = i == 0 ? 0 : random.between(2.5f, 5.5f);
        const float3 foot(far * std::sin(angle), -0.15f, far * std::cos(angle));
        const float radius = random.between(0.12f, 0.17f);
        const float length = random.between(1.0f, 1.4f);
        const float aside_z = random.between(-0.1f, 0.1f);
        const float aside_x = random.between(-0.1f, 0.1f);
        add_branch(scene.mesh, foot, glift::normalize(float3(aside_x, 1, aside_z)), length, radius, 5, random, time);
    }
    scene.view = {float3(4.5f, 3.2f, 9.5f), float3(0, 1.9f, 0), float3(0, 1, 0), 0.75f, 0.1f, 60};
    scene.light = {float3(6, 11, 5), float3(0, 1, 0), float3(0, 1, 0), 0.8f, 1, 30};
    scene.light_half_size = 11;
    return scene;
}

}  // namespace scenes
