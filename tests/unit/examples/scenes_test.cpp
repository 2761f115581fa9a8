#include "examples/common/scenes/random.h"
#include "examples/common/scenes/scenes.h"

#include <glift/host/math.h>

#include <gmock/gmock.h>

#include <cmath>

namespace {

using glift::float3;

TEST(Scenes, AreWholeAndMove) {
    for (const std::string& name : scenes::names()) {
        const scenes::Scene scene = scenes::make(name, 0.5f), later = scenes::make(name, 1.5f);
        const mesh::Mesh& mesh = scene.mesh;
        EXPECT_GT(mesh.triangles(), 5000u) << name;
        EXPECT_EQ(mesh.corners.size() % 3, 0u) << name;
        EXPECT_EQ(mesh.colours.size(), mesh.points.size()) << name;
        for (const std::uint32_t corner : mesh.corners) ASSERT_LT(corner, mesh.points.size()) << name;
        for (const float3& p : mesh.points)
            ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) << name;
        for (const float3& c : mesh.colours)
            ASSERT_TRUE(c.x >= 0 && c.x <= 1.3f && c.y >= 0 && c.y <= 1.3f && c.z >= 0) << name;
        EXPECT_EQ(mesh.corners, later.mesh.corners) << name << ": the triangles stay, their points move";
        EXPECT_NE(mesh.points, later.mesh.points) << name;
        EXPECT_EQ(mesh.points, scenes::make(name, 0.5f).mesh.points) << name;
        // The far planes of camera and light are beyond their targets.
        EXPECT_LT(glift::length(scene.view.target - scene.view.eye), scene.view.far) << name;
        EXPECT_LT(glift::length(scene.light.target - scene.light.eye), scene.light.far) << name;
    }
}

TEST(Scenes, UnknownOnesAreNamed) {
    try {
        scenes::make("forest");
        ADD_FAILURE() << "there is no such scene";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("hairball, fence, robot, skeletons, city, trees"));
    }
}

TEST(Scenes, RandomNumbersAreTheSameEverywhere) {
    scenes::Random random(1);
    const std::uint32_t first = random.bits(), second = random.bits();
    EXPECT_NE(first, second);
    scenes::Random again(1);
    EXPECT_EQ(again.bits(), first);
    float low = 1, high = 0, sum = 0;
    for (int i = 0; i < 10000; ++i) {
        const float x = random.between(2, 4);
        ASSERT_TRUE(x >= 2 && x < 4);
        low = std::min(low, (x - 2) / 2), high = std::max(high, (x - 2) / 2), sum += (x - 2) / 2;
    }
    EXPECT_LT(low, 0.01f);
    EXPECT_GT(high, 0.99f);
    EXPECT_NEAR(sum / 10000, 0.5f, 0.02f);
}

}  // namespace
