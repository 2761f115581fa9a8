#include "figure.h"
#include "random.h"
#include "scenes.h"

#include "examples/common/shapes.h"

namespace scenes {

namespace {

using glift::float3;

const float3 steel(0.55f, 0.58f, 0.62f), dark(0.12f, 0.13f, 0.15f), orange(0.85f, 0.35f, 0.05f);

/// Adds a limb of two segments of length `part`: the upper one is swung forwards by `angle`, the lower one by `bend`
/// more (backwards if negative). Returns its end.
float3 add_limb(mesh::Mesh& mesh, const Stance& stance, const float3& joint, float part, float angle, float bend,
                float thickness) {
    const float3 middle = stance.swung(joint, part, angle), end = stance.swung(middle, part, angle + bend);
    mesh::add_sphere(mesh, joint, thickness * 1.3f, 10, dark);
    mesh::add_rod(mesh, joint, middle, thickness, thickness * 0.8f, 12, steel);
    mesh::add_sphere(mesh, middle, thickness * 1.1f, 10, dark);
    mesh::add_rod(mesh, middle, end, thickness * 0.8f, thickness * 0.7f, 12, orange);
    return end;
}

void add_robot(mesh::Mesh& mesh, const Stance& stance, float step) {
    const float swing = std::sin(step);
    const float3 hips = stance.place + float3(0, 1.05f + 0.03f * std::abs(std::cos(step)), 0);
    const float3 shoulders = hips + float3(0, 0.75f, 0);
    mesh::add_rod(mesh, hips, shoulders, 0.2f, 0.32f, 8, steel);
    mesh::add_rod(mesh, shoulders, shoulders + float3(0, 0.16f, 0), 0.07f, 0.07f, 10, dark);
    const float3 head = shoulders + float3(0, 0.34f, 0);
    mesh::add_sphere(mesh, head, 0.2f, 16, orange);
    for (const float side : {-1.0f, 1.0f}) {
        mesh::add_sphere(mesh, head + stance.right() * (0.08f * side) + stance.forward * 0.17f, 0.045f, 8,
                         float3(0.9f, 0.95f, 1));
        const float forwards = side * swing;
        const float3 foot = add_limb(mesh, stance, hips + stance.right() * (0.16f * side), 0.5f, 0.5f * forwards,
                                     -0.5f * std::max(0.0f, side * std::cos(step)), 0.085f);
        mesh::add_rod(mesh, foot - stance.forward * 0.06f, foot + stance.forward * 0.2f, 0.07f, 0.05f, 8, dark);
        const float3 hand = add_limb(mesh, stance, shoulders + stance.right() * (0.38f * side) - float3(0, 0.05f, 0),
                                     0.38f, -0.6f * forwards, 0.5f + 0.2f * forwards, 0.06f);
        mesh::add_sphere(mesh, hand, 0.07f, 10, dark);
    }
    mesh::add_rod(mesh, head + float3(0, 0.18f, 0), head + float3(0, 0.42f, 0), 0.012f, 0.006f, 6, dark);
    mesh::add_sphere(mesh, head + float3(0, 0.43f, 0), 0.03f, 8, float3(0.9f, 0.1f, 0.1f));
}

}  // namespace

Scene robot(float time) {
    Scene scene;
    Random random(9);
    mesh::add_box(scene.mesh, float3(-6, -0.1f, -6), float3(6, 0, 6), float3(0.5f, 0.5f, 0.48f));
    add_robot(scene.mesh, facing(float3(0, 0, 0), 0.5f), 4 * time);
    for (int i = 0; i < 24; ++i) {
        const float angle = 6.2832f * static_cast<float>(i) / 24, far = random.between(2.2f, 4.6f),
                    size = random.between(0.15f, 0.5f);
        const float3 at(far * std::sin(angle), 0, far * std::cos(angle));
        mesh::add_box(scene.mesh, at - float3(size, 0, size), at + float3(size, 1.6f * size, size),
                      float3(0.5f, 0.36f, 0.2f) * random.between(0.6f, 1.2f));
    }
    scene.view = {float3(2.6f, 2.0f, 4.2f), float3(0, 1.05f, 0), float3(0, 1, 0), 0.7f, 0.1f, 40};
    scene.light = {float3(4, 7, 3), float3(0, 0.5f, 0), float3(0, 1, 0), 0.8f, 0.5f, 18};
    scene.light_half_size = 6;
    return scene;
}

}  // namespace scenes
