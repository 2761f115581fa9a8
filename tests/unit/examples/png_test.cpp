#include "examples/common/png.h"
#include "support/process.h"

#include <gmock/gmock.h>

namespace {

using testing::HasSubstr;

TEST(Png, WhatIsWrittenIsReadAgain) {
    const glift::test::TemporaryFolder folder;
    const std::string path = folder.path() / "a.png";
    const png::Picture picture{3, 2, {0.0f, 1.0f, 0.2f, -3.0f, 7.0f, 0.6f}};
    png::write(path, picture);
    const png::Picture again = png::read(path);
    ASSERT_EQ(again.width, 3u);
    ASSERT_EQ(again.height, 2u);
    const float expected[] = {0.0f, 1.0f, 0.2f, 0.0f, 1.0f, 0.6f};
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(again.values[i], expected[i], 1e-6) << i;
}

TEST(Png, SaysWhatIsWrong) {
    const glift::test::TemporaryFolder folder;
    const std::string path = folder.path() / "a.png";
    glift::test::write_file(path, "no picture");
    for (const std::string& each : {path, (folder.path() / "missing.png").string()}) {
        try {
            png::read(each);
            ADD_FAILURE() << each;
        } catch (const std::runtime_error& error) {
            EXPECT_THAT(error.what(), HasSubstr(each));
        }
    }
    EXPECT_THROW(png::write(folder.path() / "missing" / "b.png", {1, 1, {0.0f}}), std::runtime_error);
}

}  // namespace
