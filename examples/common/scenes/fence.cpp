#include "random.h"
#include "scenes.h"

#include "examples/common/shapes.h"

#include <glift/host/math.h>

#include <cmath>

namespace scenes {

namespace {

using glift::float3;

float hash(int x, int y) {
    auto h = static_cast<std::uint32_t>(x) * 374761393u + static_cast<std::uint32_t>(y) * 668265263u;
    h = (h ^ h >> 13) * 1274126177u;
    return static_cast<float>((h ^ h >> 16) >> 8) * 0x1p-24f;
}

/// Value noise in [0, 1]: random numbers at integer points, smoothly interpolated.
float noise(float x, float y) {
    const float cell_x = std::floor(x), cell_y = std::floor(y), u = x - cell_x, v = y - cell_y;
    const int i = static_cast<int>(cell_x), k = static_cast<int>(cell_y);
    const float s = u * u * (3 - 2 * u), t = v * v * (3 - 2 * v);
    const float low = hash(i, k) + s * (hash(i + 1, k) - hash(i, k));
    const float high = hash(i, k + 1) + s * (hash(i + 1, k + 1) - hash(i, k + 1));
    return low + t * (high - low);
}

/// Fractal noise: the sum of six octaves.
float hills(float x, float y) {
    float sum = 0, size = 0.5f;
    for (int octave = 0; octave < 6; ++octave, size *= 0.5f, x *= 2.03f, y *= 2.03f) sum += size * noise(x + 17, y + 5);
    return sum;
}

float3 mixed(const float3& a, const float3& b, float t) { return a + (b - a) * glift::clamp(t, 0.0f, 1.0f); }

/// A meadow that rises to mountains with snow.
void add_land(mesh::Mesh& mesh) {
    const auto height = [](float x, float z) {
        const float far = glift::clamp((-z - 25) / 90, 0.0f, 1.0f);
        return 0.6f * (noise(x * 0.2f, z * 0.2f) - 0.5f) * glift::clamp((-z - 2) / 6, 0.0f, 1.0f) +
               far * 46 * std::pow(hills(x * 0.022f, z * 0.022f), 1.6f);
    };
    const auto place = [&](float u, float v) {
        const float z = 8 - 160 * (1 - v) * (1 - v), x = (u - 0.5f) * (30 + 1.6f * (8 - z));
        return float3(x, height(x, z), z);
    };
    const auto colour = [&](float u, float v) {
        const float3 p = place(u, v);
        const float grain = noise(p.x * 3, p.z * 3);
        const float3 meadow = mixed(float3(0.16f, 0.3f, 0.06f), float3(0.38f, 0.42f, 0.12f), grain);
        const float3 rock = mixed(meadow, float3(0.36f, 0.33f, 0.32f), (p.y - 4) / 5);
        return mixed(rock, float3(0.92f, 0.94f, 0.97f), (p.y - 15 + 4 * grain) / 4);
    };
    mesh::add_sheet(mesh, 320, 320, place, colour);
}

void add_flag(mesh::Mesh& mesh, const float3& top, const float3& colour, float phase, float time) {
    const auto place = [&](float u, float v) {
        const float wave =
            0.12f * u * std::sin(5 * u - 4 * time + phase) + 0.03f * u * std::sin(11 * u + 7 * v - 6 * time);
        return top + float3(0.62f * u, -0.4f * v - 0.08f * u * u, wave);
    };
    const auto stripe = [&](float, float v) { return v > 0.33f && v < 0.66f ? float3(0.9f, 0.88f, 0.82f) : colour; };
    mesh::add_sheet(mesh, 24, 16, place, stripe);
}

void add_post(mesh::Mesh& mesh, float x, float z) {
    const float3 wood(0.33f, 0.22f, 0.13f);
    mesh::add_rod(mesh, float3(x, -0.3f, z), float3(x, 1.25f, z), 0.05f, 0.045f, 10, wood);
    mesh::add_sphere(mesh, float3(x, 1.28f, z), 0.06f, 8, wood);
}

}  // namespace

Scene fence(float time) {
    Scene scene;
    Random random(4);
    add_land(scene.mesh);
    const float3 colours[] = {float3(0.75f, 0.08f, 0.08f), float3(0.06f, 0.2f, 0.6f), float3(0.85f, 0.6f, 0.05f),
                              float3(0.08f, 0.45f, 0.2f)};
    const float3 wood(0.4f, 0.28f, 0.17f);
    for (int i = -6; i <= 8; ++i) {
        // The fence runs from near at the left to far at the right.
        const float x = 1.1f * static_cast<float>(i), z = 1.2f - 0.9f * static_cast<float>(i + 6);
        const float next_x = x + 1.1f, next_z = z - 0.9f;
        add_post(scene.mesh, x, z);
        for (const float y : {0.45f, 0.95f})
            mesh::add_rod(scene.mesh, float3(x, y, z), float3(next_x, y, next_z), 0.03f, 0.03f, 6, wood);
        mesh::add_rod(scene.mesh, float3(x, 1.2f, z), float3(x, 2.15f, z), 0.015f, 0.012f, 8,
                      float3(0.6f, 0.6f, 0.62f));
        add_flag(scene.mesh, float3(x, 2.12f, z), colours[static_cast<unsigned>(i + 6) % 4], random.between(0, 6),
                 time);
    }
    for (int i = 0; i < 1500; ++i) {
        const float z = random.between(-14, 4), x = random.between(-9, 9), high = random.between(0.1f, 0.4f);
        const float tip_z = z + random.between(-0.1f, 0.1f);
        const float tip_x = x + random.between(-0.1f, 0.1f);
        const float3 foot(x, 0, z), tip(tip_x, high, tip_z);
        mesh::add_rod(scene.mesh, foot, tip, 0.012f, 0.001f, 3, float3(0.2f, random.between(0.3f, 0.45f), 0.08f));
    }
    scene.view = {float3(-5.6f, 1.75f, 4.6f), float3(0.5f, 1.6f, -6), float3(0, 1, 0), 0.62f, 0.3f, 260};
    scene.light = {float3(14, 20, 12), float3(0, 0, -4), float3(0, 1, 0), 0.8f, 1, 60};
    scene.light_half_size = 18;
    scene.sky = float3(0.45f, 0.65f, 0.92f);
    return scene;
}

}  // namespace scenes
