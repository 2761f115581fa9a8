// Runs the shadows example as a user does: camera paths that are written and read again, measurements along such paths,
// and what is said where something is wrong.
#include "run_example.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <vector>

namespace {

using testing::HasSubstr;

struct ShadowsExample : testing::Test {
    glift::test::TemporaryFolder folder;

    glift::test::ProcessResult run(std::vector<std::string> options) {
        const std::vector<std::string> all = {"--scene", "robot", "--size", "64", "48", "--levels", "9"};
        options.insert(options.end(), all.begin(), all.end());
        return run_example(GLIFT_SHADOWS, options, {"GLIFT_DEVICE=host"});
    }
    /// Runs the measurement that the option `what` names, over recorded paths. Returns the JSON lines that it writes.
    std::vector<nlohmann::json> measure(const std::string& what, std::vector<std::string> options) {
        const std::vector<std::string> all = {what,         file("lines"), "--paths",    GLIFT_SHADOW_PATHS,
                                              "--scenes",   "robot,city",  "--pictures", file("pictures"),
                                              "--standard", "256"};
        options.insert(options.end(), all.begin(), all.end());
        const auto result = run(options);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        std::vector<nlohmann::json> lines;
        std::ifstream in(file("lines"));
        for (std::string line; std::getline(in, line);) lines.push_back(nlohmann::json::parse(line));
        return lines;
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

TEST_F(ShadowsExample, MeasuresItsAgreementWithRays) {
    const auto lines = measure("--agreement", {"--frames", "2"});
    ASSERT_EQ(lines.size(), 6u);  // for each of two scenes: two frames, then the scene
    for (const std::size_t i : {2u, 5u}) {
        EXPECT_EQ(lines[i]["kind"], "scene");
        EXPECT_EQ(lines[i]["frames"], 2);
        EXPECT_GE(lines[i]["rmsm"]["least"], 0.995) << lines[i];
        EXPECT_GE(lines[i]["rmsm"]["mean"], lines[i]["standard"]["mean"]) << lines[i];
        for (const std::size_t frame : {i - 2, i - 1}) {
            const double pixels = lines[frame]["pixels"], share = lines[frame]["rmsm"]["share"];
            EXPECT_GT(pixels, 500);
            EXPECT_NEAR(share, 1 - lines[frame]["rmsm"]["different"].get<double>() / pixels, 1e-9);
            EXPECT_GE(share, lines[i]["rmsm"]["least"].get<double>());
            EXPECT_EQ(lines[frame]["refused"], 0);
        }
    }
    for (const std::string name : {"robot_rmsm", "robot_asm", "city_standard"})
        EXPECT_TRUE(std::filesystem::exists(file("pictures/" + name + ".png"))) << name;
}

TEST_F(ShadowsExample, MeasuresWhatPops) {
    const auto lines = measure("--popping", {"--frames", "3"});
    ASSERT_EQ(lines.size(), 6u);  // for each of two scenes: two pairs of frames, then the scene
    for (const std::size_t i : {2u, 5u}) {
        EXPECT_EQ(lines[i]["pairs"], 2);
        for (const char* method : {"rmsm", "asm", "standard"}) {
            const nlohmann::json found = lines[i][method];
            EXPECT_LE(found["flipped"]["most"], 0.005) << lines[i];
            EXPECT_GT(found["largest"]["most"], 0.0) << lines[i];  // texels' shadows move, if only a little
            EXPECT_GE(found["largest"]["most"], found["within_999"]["most"].get<double>()) << lines[i];
        }
    }
    EXPECT_TRUE(std::filesystem::exists(file("pictures/city_rmsm_popping.png")));
    EXPECT_THAT(run({"--popping", file("lines"), "--paths", GLIFT_SHADOW_PATHS, "--frames", "1"}).err,
                HasSubstr("at least two frames"));
}

TEST_F(ShadowsExample, SaysWhatIsWrong) {
    std::ofstream(file("path.txt")) << "# a path\n0 1 2 3\n";
    EXPECT_THAT(run({"--path", file("path.txt")}).err, HasSubstr("path.txt:2: has to have 13 numbers"));
    EXPECT_THAT(run({"--pairs", "10", "--out", file("a.png")}).err, HasSubstr("--pairs"));
    EXPECT_THAT(run({"--light", "point", "--pages", "5"}).err, HasSubstr("6 pages by --pages"));
    EXPECT_THAT(run({"--path", file("nowhere.txt")}).err, HasSubstr("nowhere.txt: cannot be read"));
    EXPECT_THAT(run({"--agreement", file("a"), "--paths", "nowhere"}).err,
                HasSubstr("nowhere/hairball.path: cannot be read"));
    EXPECT_THAT(run({"--agreement", file("a"), "--paths", GLIFT_SHADOW_PATHS, "--cached"}).err,
                HasSubstr("cannot be kept"));
    EXPECT_THAT(run({"--agreement", "/nowhere/a"}).err, HasSubstr("/nowhere/a: cannot be written"));
}

}  // namespace
