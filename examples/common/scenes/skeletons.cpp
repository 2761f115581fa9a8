#include "figure.h"
#include "random.h"
#include "scenes.h"

#include "examples/common/shapes.h"

namespace scenes {

namespace {

using glift::float3;

const float3 bone(0.85f, 0.8f, 0.68f);

float3 add_bones(mesh::Mesh& mesh, const Stance& stance, const float3& joint, float part, float angle, float bend) {
    const float3 middle = stance.swung(joint, part, angle), end = stance.swung(middle, part, angle + bend);
    for (const auto& [from, to] : {std::pair(joint, middle), std::pair(middle, end)}) {
        mesh::add_rod(mesh, from, to, 0.022f, 0.02f, 7, bone);
        mesh::add_sphere(mesh, from, 0.036f, 7, bone);
        mesh::add_sphere(mesh, to, 0.034f, 7, bone);
    }
    return end;
}

/// Adds a rib, from the spine to the breastbone.
void add_rib(mesh::Mesh& mesh, const Stance& stance, const float3& back, float width, float side) {
    float3 last = back;
    for (int i = 1; i <= 6; ++i) {
        const float angle = 3.0f * static_cast<float>(i) / 6;
        const float3 next = back + stance.right() * (side * width * std::sin(angle)) +
                            stance.forward * (0.12f * (1 - std::cos(angle))) -
                            float3(0, 0.012f * static_cast<float>(i), 0);
        mesh::add_rod(mesh, last, next, 0.009f, 0.009f, 5, bone);
        last = next;
    }
}

void add_skeleton(mesh::Mesh& mesh, const Stance& stance, float beat) {
    const float3 hips = stance.place + float3(0, 0.95f + 0.05f * std::abs(std::sin(beat)), 0) +
                        stance.right() * (0.06f * std::sin(beat));
    const float3 neck = hips + float3(0, 0.55f, 0) + stance.forward * (0.05f * std::cos(beat));
    mesh::add_rod(mesh, hips, neck, 0.028f, 0.022f, 8, bone);
    mesh::add_sphere(mesh, hips, 0.09f, 10, bone);
    mesh::add_sphere(mesh, neck + float3(0, 0.2f, 0), 0.115f, 14, bone);
    mesh::add_rod(mesh, neck, neck + float3(0, 0.1f, 0), 0.02f, 0.02f, 6, bone);
    for (const float side : {-1.0f, 1.0f}) {
        for (int i = 0; i < 7; ++i)
            add_rib(mesh, stance, neck - float3(0, 0.05f + 0.052f * static_cast<float>(i), 0) - stance.forward * 0.06f,
                    0.1f + 0.008f * static_cast<float>(i), side);
        const float3 shoulder = neck + stance.right() * (0.19f * side) - float3(0, 0.03f, 0);
        mesh::add_rod(mesh, neck, shoulder, 0.016f, 0.016f, 6, bone);
        add_bones(mesh, stance, shoulder, 0.28f, 1.2f + 1.1f * std::sin(beat * 1.5f + side), 0.9f);
        const float3 foot =
            add_bones(mesh, stance, hips + stance.right() * (0.09f * side), 0.45f, 0.35f * std::sin(beat + side * 1.5f),
                      -0.4f * std::max(0.0f, std::sin(beat + side)));
        mesh::add_rod(mesh, foot, foot + stance.forward * 0.16f, 0.025f, 0.012f, 6, bone);
    }
}

}  // namespace

Scene skeletons(float time) {
    Scene scene;
    Random random(13);
    mesh::add_box(scene.mesh, float3(-7, -0.1f, -7), float3(7, 0, 7), float3(0.32f, 0.3f, 0.28f));
    for (int i = 0; i < 9; ++i) {
        const float z = 1.5f * static_cast<float>(i / 3 - 1) + random.between(-0.2f, 0.2f);
        const float x = 1.5f * static_cast<float>(i % 3 - 1) + random.between(-0.2f, 0.2f);
        const float start = random.between(0, 6);
        add_skeleton(scene.mesh, facing(float3(x, 0, z), random.between(-0.5f, 0.9f)), 3 * time + start);
    }
    scene.view = {float3(2.6f, 2.3f, 5.2f), float3(0, 0.9f, 0), float3(0, 1, 0), 0.7f, 0.1f, 40};
    scene.light = {float3(3, 6, 4), float3(0, 0.5f, 0), float3(0, 1, 0), 0.8f, 0.5f, 18};
    scene.light_half_size = 6;
    return scene;
}

}  // namespace scenes
