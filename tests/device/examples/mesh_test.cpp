// Runs the mesh example, which draws by a `raster` declared in Glift, as a user does: the pictures of the host device
// and of lavapipe differ in few pixels, and an unknown scene is refused.
#include "run_example.h"

#include "examples/common/picture.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace {

using picture::Picture;

struct Meshes : testing::Test {
    glift::test::TemporaryFolder folder;

    Picture drawn(const std::string& device, const std::string& what) {
        const std::string out = folder.path() / (device + ".exr");
        const auto result =
            run_example(GLIFT_MESH, {what, "--out", out, "--size", "240", "160"}, {"GLIFT_DEVICE=" + device});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return picture::read(out);
    }
};

float farthest(const glift::float4& a, const glift::float4& b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

TEST_F(Meshes, LookTheSameOnBothDevices) {
    const Picture host = drawn("host", "robot"), vulkan = drawn("lavapipe", "robot");
    ASSERT_EQ(host.pixels.size(), vulkan.pixels.size());
    std::size_t differ = 0, sky = 0;
    for (std::size_t i = 0; i < host.pixels.size(); ++i) {
        differ += farthest(host.pixels[i], vulkan.pixels[i]) > 1e-3f;
        sky += farthest(host.pixels[i], host.pixels[0]) == 0;
    }
    // Whether pixels at edges are covered depends on the last bits of the vertices.
    EXPECT_LE(differ, host.pixels.size() / 1000);
    EXPECT_GT(sky, host.pixels.size() / 10);
    EXPECT_LT(sky, host.pixels.size() * 9 / 10);
}

TEST_F(Meshes, AreRefusedByName) {
    const auto result = run_example(GLIFT_MESH, {"teapot"}, {"GLIFT_DEVICE=host"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, testing::HasSubstr("robot")) << "the scenes that there are";
}

}  // namespace
