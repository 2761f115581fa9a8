// The range of a light's depths (examples/shadows/fitted_light.h): it begins no farther from the light than any
// triangle in sight, and not much nearer than the nearest one.
#include "shadow_scenes.h"

#include <glift/host/math.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace {

using glift::float3;

/// The least depth of many points on all triangles: the distance from the light along the spot's axis, or along the
/// axis of the point light's face that sees the point. Points that a spot does not see are left out.
float least_of_many_points(const scenes::Scene& scene, LightKind kind, float opening) {
    const float3 forward = glift::normalize(scene.light.target - scene.light.eye);
    const float3 right = glift::normalize(glift::cross(forward, camera::up_of(scene.light)));
    const float3 down = glift::cross(forward, right);
    float least = std::numeric_limits<float>::max();
    constexpr int parts = 40;
    for (std::size_t i = 0; i < scene.mesh.corners.size(); i += 3)
        for (int a = 0; a <= parts; ++a)
            for (int b = 0; a + b <= parts; ++b) {
                const auto corner = [&](std::size_t k) { return scene.mesh.points[scene.mesh.corners[i + k]]; };
                const float u = static_cast<float>(a) / parts, v = static_cast<float>(b) / parts;
                const float3 way = corner(0) * (1 - u - v) + corner(1) * u + corner(2) * v - scene.light.eye;
                const float away = glift::dot(forward, way);
                const float aside = std::max(std::abs(glift::dot(right, way)), std::abs(glift::dot(down, way)));
                if (kind == LightKind::point)
                    least = std::min(least, std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z)}));
                else if (away > 0 && aside <= opening * away) least = std::min(least, away);
            }
    return least;
}

TEST(FittedLight, BeginsBeforeAllTrianglesInSight) {
    std::mt19937 random(5);
    const auto number = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
    for (int round = 0; round < 60; ++round) {
        scenes::Scene scene;
        scene.light = {float3(0, 0, 0), float3(number() - 0.5f, -1, number() - 0.5f), float3(0, 0, 1), 0.9f, 0.01f, 3};
        for (int k = 0; k < 12; ++k) {
            const float3 a((number() - 0.5f) * 8, -0.5f - 3 * number(), (number() - 0.5f) * 8);
            const float3 u(number() - 0.5f, number() - 0.5f, number() - 0.5f);
            const float3 v(number() - 0.5f, number() - 0.5f, number() - 0.5f);
            add_quad(scene.mesh, a, u * 3.0f, v * 3.0f);
        }
        for (const LightKind kind : {LightKind::spot, LightKind::point}) {
            const float opening = kind == LightKind::spot ? std::tan(0.45f) : 1.02f;
            const camera::Camera light = fitted_light(scene, kind, opening);
            EXPECT_LE(light.near, least_of_many_points(scene, kind, opening) / (kind == LightKind::point ? 1.02f : 1))
                << round;
            EXPECT_GE(light.near, scene.light.near) << round;
            EXPECT_GE(light.far, scene.light.far) << round;
        }
    }
}

/// A wall at distance 5 in front of the light, and a floor 2 below the light, from the wall to behind the light.
TEST(FittedLight, BeginsNearTheNearestTriangle) {
    scenes::Scene scene;
    add_quad(scene.mesh, {-9, -9, -5}, {18, 0, 0}, {0, 18, 0});
    scene.light = {float3(0, 0, 0), float3(0, 0, -5), float3(0, 1, 0), 0.9f, 0.01f, 3};
    EXPECT_NEAR(fitted_light(scene, LightKind::spot, std::tan(0.45f)).near, 5, 0.06);  // `near` is at most 0.99 `far`
    EXPECT_NEAR(fitted_light(scene, LightKind::point, 1).near, 5, 0.01);
    EXPECT_NEAR(fitted_light(scene, LightKind::point, 1).far, 9, 0.01);
    add_quad(scene.mesh, {-9, -2, -5}, {18, 0, 0}, {0, 0, 9});
    EXPECT_NEAR(fitted_light(scene, LightKind::spot, std::tan(0.45f)).near, 2, 0.01);
    EXPECT_NEAR(fitted_light(scene, LightKind::point, 1).near, 2, 0.01);
    add_quad(scene.mesh, {-1, -1, 1}, {2, 0, 0}, {0, 2, -2});  // through the light
    EXPECT_EQ(fitted_light(scene, LightKind::point, 1).near, 0.01f);
}

}  // namespace
