#include "random.h"
#include "scenes.h"

#include "examples/common/shapes.h"

#include <cmath>

namespace scenes {

namespace {

using glift::float3;

constexpr int blocks = 20;
constexpr float block = 4.0f, house = 3.0f;

/// A tower of up to three steps, each with rows of windows.
void add_house(mesh::Mesh& mesh, const float3& corner, float high, Random& random) {
    const float shade = random.between(0.35f, 0.75f);
    const float blue = shade * random.between(0.75f, 1);
    const float green = shade * random.between(0.85f, 1);
    const float3 wall(shade, green, blue), glass(0.1f, 0.16f, 0.22f);
    const int steps = high > 6 ? 3 : high > 3 ? 2 : 1;
    float from = 0;
    for (int step = 0; step < steps; ++step) {
        const float in = 0.35f * static_cast<float>(step),
                    to = high * static_cast<float>(step + 1) / static_cast<float>(steps);
        const float3 low = corner + float3(in, from, in), top(corner.x + house - in, to, corner.z + house - in);
        mesh::add_box(mesh, low, top, wall);
        for (float y = from + 0.3f; y + 0.3f < to; y += 0.55f)
            mesh::add_box(mesh, float3(low.x - 0.015f, y, low.z - 0.015f),
                          float3(top.x + 0.015f, y + 0.25f, top.z + 0.015f), glass);
        from = to;
    }
}

void add_car(mesh::Mesh& mesh, const float3& at, bool along_x, const float3& colour) {
    const float3 half = along_x ? float3(0.3f, 0, 0.13f) : float3(0.13f, 0, 0.3f);
    const float3 roof = half * 0.6f + float3(0.02f, 0, 0.02f);
    mesh::add_box(mesh, at - half + float3(0, 0.05f, 0), at + half + float3(0, 0.18f, 0), colour);
    mesh::add_box(mesh, at - roof + float3(0, 0.18f, 0), at + roof + float3(0, 0.3f, 0), float3(0.1f, 0.12f, 0.14f));
}

}  // namespace

Scene city(float time) {
    Scene scene;
    Random random(21);
    const float half = 0.5f * block * blocks;
    mesh::add_box(scene.mesh, float3(-half - 10, -0.1f, -half - 10), float3(half + 10, 0, half + 10),
                  float3(0.2f, 0.2f, 0.21f));
    for (int z = 0; z < blocks; ++z) {
        for (int x = 0; x < blocks; ++x) {
            const float3 corner(block * static_cast<float>(x) - half + 0.5f, 0,
                                block * static_cast<float>(z) - half + 0.5f);
            const float middle = std::hypot(corner.x, corner.z) / half;
            const float least = random.between(1.2f, 3);
            const float high = least + 9 * std::pow(random.between(0, 1), 3.0f) * std::max(0.15f, 1 - middle);
            mesh::add_box(scene.mesh, corner - float3(0.15f, 0, 0.15f),
                          corner + float3(house + 0.15f, 0.05f, house + 0.15f), float3(0.45f, 0.45f, 0.44f));
            add_house(scene.mesh, corner, high, random);
        }
    }
    for (int i = 0; i < 160; ++i) {
        const float lane = block * std::floor(random.between(1, blocks)) - half + (i % 2 ? -0.17f : 0.17f);
        const float speed = random.between(1, 3) * (i % 2 ? 1.0f : -1.0f), start = random.between(0, 2 * half);
        const float along = std::fmod(std::fmod(start + speed * time, 2 * half) + 2 * half, 2 * half) - half;
        const float3 colour = random.inside(float3(0.1f), float3(0.9f, 0.6f, 0.6f));
        const bool along_x = i % 4 < 2;
        add_car(scene.mesh, along_x ? float3(along, 0, lane) : float3(lane, 0, along), along_x, colour);
    }
    scene.view = {float3(17, 13, 27), float3(0, 1, 0), float3(0, 1, 0), 0.75f, 0.5f, 160};
    scene.light = {float3(30, 42, 18), float3(0, 0, 0), float3(0, 1, 0), 0.8f, 1, 120};
    scene.light_half_size = 52;
    return scene;
}

}  // namespace scenes
