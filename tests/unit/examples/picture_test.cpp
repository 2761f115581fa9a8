#include "examples/common/picture.h"
#include "support/process.h"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

namespace {

using glift::float4;
using picture::Picture;

Picture gradient(std::uint32_t width, std::uint32_t height) {
    Picture made{width, height, {}, {}};
    for (std::uint32_t i = 0; i < width * height; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(width * height);
        made.pixels.emplace_back(t, 0.5f * t, 1 - t, 0.25f + 0.5f * t);
        made.depth.push_back(100 * t);
    }
    return made;
}

TEST(Picture, OpenExrKeepsEveryBit) {
    const glift::test::TemporaryFolder folder;
    const std::string path = folder.path() / "a.exr";
    Picture written = gradient(7, 5);
    written.pixels[3] = float4(-2.5f, 1e10f, 3e-20f, 7);
    picture::write(path, written);
    const Picture again = picture::read(path);
    ASSERT_EQ(again.width, 7u);
    ASSERT_EQ(again.height, 5u);
    EXPECT_EQ(again.pixels, written.pixels);
    EXPECT_EQ(again.depth, written.depth);
    written.depth.clear();
    picture::write(path, written);
    EXPECT_TRUE(picture::read(path).depth.empty());
}

TEST(Picture, SaysThatTheDiskIsFull) {
    const glift::test::TemporaryFolder folder;
    const std::string path = folder.path() / "a.png";
    std::filesystem::create_symlink("/dev/full", path);
    try {
        picture::write(path, gradient(7, 5));
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_EQ(error.what(), path + ": cannot be written");
    }
}

TEST(Picture, PngIsCodedAsScreensShowIt) {
    const glift::test::TemporaryFolder folder;
    const std::string path = folder.path() / "a.png";
    Picture written{
        2,
        2,
        {float4(0, 1, 0.2140f, 1), float4(7, -1, NAN, 0.5f), float4(0.5f, 0.5f, 0.5f, 0), float4(1, 1, 1, 1)},
        {}};
    picture::write(path, written);
    const Picture again = picture::read(path);
    ASSERT_EQ(again.pixels.size(), 4u);
    EXPECT_NEAR(again.pixels[0].z, 0.2140f, 0.004f);  // 127 or 128 of 255
    EXPECT_EQ(again.pixels[1].x, 1);
    EXPECT_EQ(again.pixels[1].y, 0);
    EXPECT_EQ(again.pixels[1].z, 0);
    EXPECT_NEAR(again.pixels[1].w, 0.5f, 0.003f);
    EXPECT_NEAR(again.pixels[2].x, 0.5f, 0.006f);
}

TEST(Picture, SaysWhatIsWrong) {
    const glift::test::TemporaryFolder folder;
    const auto refuses = [](auto action, const std::string& words) {
        try {
            action();
            ADD_FAILURE() << "nothing was thrown; expected: " << words;
        } catch (const std::runtime_error& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr(words));
        }
    };
    const std::string exr = folder.path() / "a.exr", other = folder.path() / "a.jpg";
    glift::test::write_file(exr, "no picture");
    refuses([&] { picture::read(exr); }, "a.exr: cannot be read as an OpenEXR file");
    refuses([&] { picture::read(folder.path() / "missing.exr"); }, "missing.exr: cannot be read");
    refuses([&] { picture::read(folder.path() / "missing.png"); }, "missing.png: cannot be read as a PNG");
    refuses([&] { picture::read(other); }, ".png or .exr");
    refuses([&] { picture::write(other, gradient(2, 2)); }, ".png or .exr");
    refuses([&] { picture::write(folder.path() / "no" / "folder.exr", gradient(2, 2)); }, "cannot be written");
    refuses([&] { picture::write(folder.path() / "b.png", {2, 2, {}, {}}); }, "not as many as its size says");
}

}  // namespace
