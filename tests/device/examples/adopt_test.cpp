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
    // Squares of 20: their middles are far from every edge and keep their colours; edges are grey.
    const png::Picture picture = png::read(path);
    ASSERT_EQ(picture.width, 203u);
    EXPECT_EQ(picture.values[10 * 203 + 10], 0.0f);
    EXPECT_EQ(picture.values[10 * 203 + 30], 1.0f);
    EXPECT_EQ(picture.values[30 * 203 + 10], 1.0f);
    EXPECT_GT(picture.values[10 * 203 + 19], 0.2f);
    EXPECT_LT(picture.values[10 * 203 + 19], 0.5f);
}

}  // namespace
