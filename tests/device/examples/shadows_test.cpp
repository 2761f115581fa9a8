// Shadows as a user makes them: paths that are written and read again, and what is said where something is wrong.
#include "run_example.h"

#include <gmock/gmock.h>

#include <fstream>

namespace {

using testing::HasSubstr;

struct ShadowsExample : testing::Test {
    glift::test::TemporaryFolder folder;

    glift::test::ProcessResult run(std::vector<std::string> options) {
        const std::vector<std::string> all = {"--scene", "robot", "--size", "64", "48", "--levels", "9"};
        options.insert(options.end(), all.begin(), all.end());
        return run_example(GLIFT_SHADOWS, options, {"GLIFT_DEVICE=host"});
    }
    std::string file(const std::string& name) { return folder.path() / name; }
};

TEST_F(ShadowsExample, RepeatsAPath) {
    ASSERT_EQ(run({"--frames", "2", "--write-path", file("path.txt"), "--out", file("a.png")}).exit_code, 0);
    const auto again = run({"--path", file("path.txt"), "--out", file("b.png")});
    ASSERT_EQ(again.exit_code, 0) << again.err;
    for (const std::string frame : {".0000.png", ".0001.png"})
        EXPECT_EQ(glift::test::read_file(file("a" + frame)), glift::test::read_file(file("b" + frame)));
    EXPECT_NE(glift::test::read_file(file("a.0000.png")), glift::test::read_file(file("a.0001.png")));
}

TEST_F(ShadowsExample, SaysWhatIsWrong) {
    std::ofstream(file("path.txt")) << "# a path\n0 1 2 3\n";
    EXPECT_THAT(run({"--path", file("path.txt")}).err, HasSubstr("path.txt:2: has to have 13 numbers"));
    EXPECT_THAT(run({"--pairs", "10", "--out", file("a.png")}).err, HasSubstr("--pairs"));
    EXPECT_THAT(run({"--path", file("nowhere.txt")}).err, HasSubstr("nowhere.txt: cannot be read"));
}

}  // namespace
