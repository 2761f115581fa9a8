#include "run_example.h"

#include "examples/common/png.h"

#include <gmock/gmock.h>

namespace {

using testing::HasSubstr;

TEST(Adopt, ThePictureIsWhatTheProgramComputesItself) {
    const glift::test::TemporaryFolder folder;
    const std::string path = folder.path() / "picture.png";
    const auto result =
        run_example(GLIFT_ADOPT, {path}, {"VK_ICD_FILENAMES=/usr/share/vulkan/icd.d/lvp_icd.x86_64.json"});
    ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
    EXPECT_THAT(result.out, HasSubstr("as expected, to the bit"));
    // The program clears the image to a colour, which remains in a margin of 12 pixels. Squares are 20 pixels wide, and
    // the blur reaches 8, so that the middles of white squares stay white. Pixels darker than 0.25 are not drawn: the
    // middles of black squares have the clear colour. Beside a white square a black one is grey, 0.25 to 0.5, and
    // drawn.
    const png::Picture picture = png::read(path);
    ASSERT_EQ(picture.width, 227u);
    const auto at = [&](std::uint32_t x, std::uint32_t y) { return picture.values[(y + 12) * 227 + x + 12]; };
    const float paper = picture.values[0];
    EXPECT_NEAR(paper, 0.75f, 0.005f);
    EXPECT_EQ(at(10, 10), paper);
    EXPECT_EQ(at(30, 10), 1.0f);
    EXPECT_EQ(at(10, 30), 1.0f);
    EXPECT_GT(at(19, 10), 0.25f);
    EXPECT_LT(at(19, 10), 0.5f);
}

}  // namespace
