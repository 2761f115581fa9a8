#include "examples/common/camera.h"

#include <glift/host/math.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using camera::Camera;
using glift::float3;
using glift::float4;
using glift::float4x4;

float4 projected(const float4x4& m, const float3& p) { return m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3]; }

TEST(Camera, ProjectsAsVulkanWants) {
    const Camera camera{float3(0, 0, 10), float3(0, 0, 0), float3(0, 1, 0), 1.0f, 1, 21};
    const float4x4 m = camera::projection_of(camera, 2);
    const float4 centre = projected(m, float3(0, 0, 0));
    EXPECT_NEAR(centre.x / centre.w, 0, 1e-6f);
    EXPECT_NEAR(centre.w, 10, 1e-5f);
    const float4 near = projected(m, float3(0, 0, 9)), far = projected(m, float3(0, 0, -11));
    EXPECT_NEAR(near.z / near.w, 0, 1e-6f);
    EXPECT_NEAR(far.z / far.w, 1, 1e-6f);
    const float half = 10 * std::tan(0.5f);
    const float4 top = projected(m, float3(0, half, 0)), right = projected(m, float3(2 * half, 0, 0));
    EXPECT_NEAR(top.y / top.w, -1, 1e-5f);  // y grows downwards
    EXPECT_NEAR(right.x / right.w, 1, 1e-5f);
}

TEST(Camera, SeesTheFacesOfACube) {
    const float3 eye(1, 2, 3);
    for (unsigned i = 0; i < 6; ++i) {
        const auto [forward, right, down] = camera::cube_face(i);
        // The middle of a face and its axes must be those of cube_direction in std.image.
        const float side = i % 2 == 0 ? 1.0f : -1.0f;
        EXPECT_EQ(forward[i / 2], side);
        EXPECT_EQ(glift::dot(right, i < 2 ? float3(0, 0, -side) : i < 4 ? float3(1, 0, 0) : float3(side, 0, 0)), 1);
        EXPECT_EQ(glift::dot(down, i == 2 || i == 3 ? float3(0, 0, side) : float3(0, -1, 0)), 1);
        const float4x4 m = camera::cube_projection_of(eye, i, 1.25f, 0.5f, 8);
        const float4 p = projected(m, eye + forward * 4.0f + right * 2.0f + down * -5.0f);
        EXPECT_NEAR(p.x / p.w, 0.4f, 1e-6f);
        EXPECT_NEAR(p.y / p.w, -1, 1e-6f);
        EXPECT_NEAR(p.w, 4, 1e-6f);
        const float4 near = projected(m, eye + forward * 0.5f), far = projected(m, eye + forward * 8.0f);
        EXPECT_NEAR(near.z / near.w, 0, 1e-6f);
        EXPECT_NEAR(far.z / far.w, 1, 1e-6f);
    }
}

TEST(Camera, ParallelProjectionKeepsSizes) {
    const Camera light{float3(3, 4, 5), float3(0, 0, 0), float3(0, 1, 0), 1.0f, 1, 11};
    const float4x4 m = camera::parallel_projection_of(light, 2);
    const float4 target = projected(m, light.target),
                 beside = projected(m, light.target + float3(0.8f, 0, -0.6f) * -1.0f);
    EXPECT_NEAR(target.x, 0, 1e-6f);
    EXPECT_NEAR(target.w, 1, 1e-6f);
    EXPECT_NEAR(target.z, (std::sqrt(50.0f) - 1) / 10, 1e-5f);
    EXPECT_LE(std::abs(beside.x), 0.5f + 1e-5f);
}

TEST(Camera, OrbitsAroundItsTarget) {
    const Camera camera{float3(1, 2, 7), float3(1, 2, 3), float3(0, 1, 0), 1.0f, 1, 11};
    const Camera right = camera::orbited(camera, 0.5f, 0, 1), above = camera::orbited(camera, 0, 0.3f, 2);
    EXPECT_NEAR(glift::length(right.eye - camera.target), 4, 1e-5f);
    EXPECT_NEAR(right.eye.y, 2, 1e-5f);
    EXPECT_GT(right.eye.x, 1);  // the eye is at z > the target's and looks along -z: x grows to the right
    const float4 before = projected(camera::projection_of(right, 1), camera.target + float3(0, 0, 1));
    EXPECT_LT(before.x / before.w, 0);  // what is in front of the target moves to the left in the picture
    EXPECT_NEAR(glift::length(above.eye - camera.target), 2, 1e-5f);
    EXPECT_GT(above.eye.y, 2);
    EXPECT_TRUE(std::isfinite(camera::orbited(camera, 0, 100, 1).eye.y));
}

}  // namespace
