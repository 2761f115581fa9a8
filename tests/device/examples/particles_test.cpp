// Runs the particles example as a user does: a step is one submission, the pictures of both devices differ in few
// pixels, and the fluid falls and flows.
#include "run_example.h"

#include "examples/common/picture.h"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

namespace {

using picture::Picture;
using testing::HasSubstr;

struct Particles : testing::Test {
    glift::test::TemporaryFolder folder;

    glift::test::ProcessResult run(const std::string& device, const std::vector<std::string>& options) {
        std::vector<std::string> all = {"--out", folder.path() / device};
        all.insert(all.end(), options.begin(), options.end());
        return run_example(GLIFT_PARTICLES, all, {"GLIFT_DEVICE=" + device});
    }
    Picture picture_of(const std::string& device, const std::string& name) const {
        return picture::read(std::filesystem::path(folder.path()) / device / name);
    }
};

/// Tells the fluid by its blue: the sky and the floor are dark, the ball is red.
bool is_fluid(const glift::float4& pixel) { return pixel.z > 0.1f; }

/// The centre of the fluid's pixels: x to the right and y up, both from 0 to 1.
glift::float2 middle_of(const Picture& picture) {
    glift::float2 sum{0, 0};
    float n = 0;
    for (std::uint32_t y = 0; y < picture.height; ++y)
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            if (!is_fluid(picture.pixels[y * picture.width + x])) continue;
            sum = sum + glift::float2{static_cast<float>(x) / static_cast<float>(picture.width),
                                      1 - static_cast<float>(y) / static_cast<float>(picture.height)};
            n += 1;
        }
    return sum * (1 / n);
}

TEST_F(Particles, FlowAlikeOnBothDevices) {
    const std::vector<std::string> options = {"--particles", "1000", "--steps", "60",
                                              "--every",     "60",   "--width", "256"};
    const auto host = run("host", options), vulkan = run("lavapipe", options);
    ASSERT_EQ(host.exit_code, 0) << host.err;
    ASSERT_EQ(vulkan.exit_code, 0) << vulkan.err;
    EXPECT_THAT(vulkan.out, HasSubstr("60 steps, 60 submissions, 0 waits"));
    for (const std::string name : {"fluid_0000.png", "fluid_0060.png"}) {
        const Picture a = picture_of("host", name), b = picture_of("lavapipe", name);
        ASSERT_EQ(a.pixels.size(), b.pixels.size());
        std::size_t differ = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) differ += std::abs(a.pixels[i].x - b.pixels[i].x) > 0.02f;
        EXPECT_LE(differ, a.pixels.size() / 500) << name;
    }
    const glift::float2 before = middle_of(picture_of("host", "fluid_0000.png")),
                        after = middle_of(picture_of("host", "fluid_0060.png"));
    EXPECT_GT(after.x, before.x + 0.05f);
    EXPECT_LT(after.y, before.y - 0.05f);
}

TEST_F(Particles, SaysWhatItTakes) {
    const auto result = run("host", {"--particles", "3"});
    EXPECT_NE(result.exit_code, 0);
    EXPECT_THAT(result.err, HasSubstr("--particles"));
}

}  // namespace
