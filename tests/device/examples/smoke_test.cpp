// Runs the smoke example as a user does: pages follow the smoke, which rises, alike on both devices.
#include "run_example.h"

#include "examples/common/picture.h"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

namespace {

using picture::Picture;
using testing::HasSubstr;

struct Smoke : testing::Test {
    glift::test::TemporaryFolder folder;

    glift::test::ProcessResult run(const std::string& device, const std::vector<std::string>& options) {
        std::vector<std::string> all = {"--extent", "128", "--every", "30", "--out", folder.path() / device};
        all.insert(all.end(), options.begin(), options.end());
        return run_example(GLIFT_SMOKE, all, {"GLIFT_DEVICE=" + device});
    }
    Picture picture_of(const std::string& device, const std::string& name) const {
        return picture::read(std::filesystem::path(folder.path()) / device / name);
    }
};

/// The first row with smoke.
std::size_t top(const Picture& picture) {
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        if (picture.pixels[i].x > 0.2f) return i / picture.width;
    return picture.height;
}

TEST_F(Smoke, RisesAlikeOnBothDevices) {
    for (const std::string device : {"host", "lavapipe"}) {
        const auto result = run(device, {"--steps", "60", "--rounds", "8"});
        ASSERT_EQ(result.exit_code, 0) << result.err;
    }
    const Picture early = picture_of("host", "smoke_00030.png"), late = picture_of("host", "smoke_00060.png"),
                  other = picture_of("lavapipe", "smoke_00060.png");
    EXPECT_LT(top(late) + 5, top(early));
    std::size_t differ = 0, pages = 0;
    for (std::size_t i = 0; i < late.pixels.size(); ++i) {
        differ += std::abs(late.pixels[i].x - other.pixels[i].x) > 0.02f;
        pages += late.pixels[i].x > 0.015f;
    }
    EXPECT_LE(differ, late.pixels.size() / 500);
    EXPECT_LT(pages, late.pixels.size() / 2);  // elsewhere no page is
}

TEST_F(Smoke, SaysWhenThePoolIsTooSmall) {
    const auto result = run("host", {"--steps", "60", "--pages", "3"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr("--pages"));
}

}  // namespace
