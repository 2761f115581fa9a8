// Runs the narrow-band example as a user does: a step is one submission, the pictures of both devices differ in few
// pixels, and the front expands.
#include "run_example.h"

#include "examples/common/picture.h"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

namespace {

using picture::Picture;
using testing::HasSubstr;

struct NarrowBand : testing::Test {
    glift::test::TemporaryFolder folder;

    glift::test::ProcessResult run(const std::string& device, const std::vector<std::string>& options) {
        std::vector<std::string> all = {"--extent", "96", "--size", "96",
                                        "--every",  "0",  "--out",  folder.path() / device};
        all.insert(all.end(), options.begin(), options.end());
        return run_example(GLIFT_NARROW_BAND, all, {"GLIFT_DEVICE=" + device});
    }
    Picture picture_of(const std::string& device, const std::string& name) const {
        return picture::read(std::filesystem::path(folder.path()) / device / name);
    }
};

/// The number of pixels inside the front, which have warm colours.
std::size_t inside(const Picture& slice) {
    std::size_t n = 0;
    for (const glift::float4& pixel : slice.pixels) n += pixel.x > 2 * pixel.z;
    return n;
}

TEST_F(NarrowBand, MovesAlikeOnBothDevices) {
    const std::vector<std::string> options = {"--balls", "9", "--steps", "24", "--seed", "2"};
    const auto host = run("host", options), vulkan = run("lavapipe", options);
    ASSERT_EQ(host.exit_code, 0) << host.err;
    ASSERT_EQ(vulkan.exit_code, 0) << vulkan.err;
    EXPECT_THAT(vulkan.out, HasSubstr("24 steps, 24 submissions, 0 waits"));
    for (const std::string name : {"front_0024.png", "slice_0024.png"}) {
        const Picture a = picture_of("host", name), b = picture_of("lavapipe", name);
        ASSERT_EQ(a.pixels.size(), b.pixels.size());
        std::size_t differ = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) differ += std::abs(a.pixels[i].x - b.pixels[i].x) > 0.02f;
        EXPECT_LE(differ, a.pixels.size() / 500) << name;
    }
    const Picture before = picture_of("host", "slice_0000.png"), after = picture_of("host", "slice_0024.png");
    EXPECT_GT(inside(before), 20u);
    EXPECT_GT(inside(after), inside(before));  // the front expands
}

TEST_F(NarrowBand, GoesOnWithABandOfAFile) {
    if (run("host", {"--help"}).out.find("--save") == std::string::npos) GTEST_SKIP() << "libglift_files is not built";
    const std::string file = folder.path() / "band.h5";
    ASSERT_EQ(run("host", {"--balls", "9", "--steps", "24"}).exit_code, 0);
    const Picture whole = picture_of("host", "slice_0024.png");
    ASSERT_EQ(run("host", {"--balls", "9", "--steps", "12", "--save", file}).exit_code, 0);
    const auto rest = run("host", {"--steps", "12", "--from", file});
    ASSERT_EQ(rest.exit_code, 0) << rest.err;
    const Picture resumed = picture_of("host", "slice_0012.png");
    ASSERT_EQ(resumed.pixels.size(), whole.pixels.size());
    for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
        ASSERT_EQ(resumed.pixels[i].x, whole.pixels[i].x);
        ASSERT_EQ(resumed.pixels[i].z, whole.pixels[i].z);
    }
}

TEST_F(NarrowBand, SaysWhenThePoolIsTooSmall) {
    const auto result = run("host", {"--balls", "9", "--steps", "2", "--pages", "20"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr("--pages"));
}

}  // namespace
