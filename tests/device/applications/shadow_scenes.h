// Small scenes and settings for tests of examples/shadows.
#pragma once

#include "examples/shadows/frame.h"

inline void add_quad(mesh::Mesh& mesh, const glift::float3& a, const glift::float3& u, const glift::float3& v) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const glift::float3& p : {a, a + u, a + u + v, a + v}) {
        mesh.points.push_back(p);
        mesh.colours.emplace_back(0.6f, 0.6f, 0.6f);
    }
    for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.corners.push_back(first + corner);
}

/// A grid of posts on a floor, seen so that near posts need fine levels and far ones coarse ones.
inline scenes::Scene posts() {
    scenes::Scene scene;
    add_quad(scene.mesh, {-4, 0, -4}, {8, 0, 0}, {0, 0, 8});
    for (int i = 0; i < 49; ++i) {
        const float x = -3 + static_cast<float>(i % 7), z = -3 + static_cast<float>(i / 7);
        add_quad(scene.mesh, {x, 0, z}, {0.09f, 0, 0.03f}, {0.02f, 0.8f, 0.01f});
        add_quad(scene.mesh, {x, 0, z}, {-0.03f, 0, 0.09f}, {0.01f, 0.8f, 0.02f});
    }
    scene.view = {
        glift::float3(0.7f, 1.1f, 4.2f), glift::float3(0.2f, 0.2f, 0), glift::float3(0, 1, 0), 0.8f, 0.1f, 20};
    scene.light = {glift::float3(2, 5, 3), glift::float3(0, 0, 0), glift::float3(0, 1, 0), 1.2f, 0.5f, 12};
    scene.light_half_size = 6;
    return scene;
}

/// The posts under a ceiling, with the light between them: light and shadow on all sides of a point light.
inline scenes::Scene room() {
    scenes::Scene scene = posts();
    add_quad(scene.mesh, {-4, 1.4f, -4}, {8, 0, 0}, {0, 0, 8});
    scene.view.target = glift::float3(0.2f, 0.5f, 0);
    scene.light = {glift::float3(0.3f, 0.55f, 0.2f), glift::float3(0, 0, 0), glift::float3(0, 1, 0), 1.2f, 0.02f, 12};
    return scene;
}

/// The room, seen so that no triangle leaves the view: where triangles are clipped, devices may cover different pixels.
inline scenes::Scene all_of_room() {
    scenes::Scene scene = room();
    scene.view.eye.z = 12;
    return scene;
}

inline Settings small() {
    Settings settings;
    settings.levels = 8, settings.pages = 256, settings.pairs = 20'000, settings.standard = 256, settings.seed = 5;
    settings.rounds = 3;
    return settings;
}
