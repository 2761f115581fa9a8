// Runs the shadows example as a user does: a mesh from a file by all methods, views and lights on two devices, camera
// paths that are written and read again, measurements along such paths, and what is said where something is wrong.
#include "run_example.h"

#include "examples/common/picture.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <vector>

namespace {

using testing::HasSubstr;

struct ShadowsExample : testing::Test {
    glift::test::TemporaryFolder folder;

    glift::test::ProcessResult run(std::vector<std::string> options) {
        options.insert(options.end(), {"--scene", "robot"});
        return walk(options);
    }
    /// Adds no --scene: measurements along recorded paths do not allow it.
    glift::test::ProcessResult walk(std::vector<std::string> options) {
        options.insert(options.end(), {"--size", "64", "48", "--levels", "9"});
        return run_example(GLIFT_SHADOWS, options, {"GLIFT_DEVICE=host"});
    }
    /// Runs the measurement that the option `what` names, over recorded paths. Returns the JSON lines that it writes.
    std::vector<nlohmann::json> measure(const std::string& what, std::vector<std::string> options) {
        const std::vector<std::string> all = {what,         file("lines"), "--paths",    GLIFT_SHADOW_PATHS,
                                              "--scenes",   "robot,city",  "--pictures", file("pictures"),
                                              "--standard", "256"};
        options.insert(options.end(), all.begin(), all.end());
        const auto result = walk(options);
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
            EXPECT_EQ(lines[frame]["coarsened"], 0);
            EXPECT_EQ(lines[frame]["asm_coarsened"], 0);
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
            EXPECT_GT(found["largest"]["most"], 0.0) << lines[i];  // the light of some pixel changes, if only a little
            EXPECT_GE(found["largest"]["most"], found["within_999"]["most"].get<double>()) << lines[i];
        }
    }
    EXPECT_TRUE(std::filesystem::exists(file("pictures/city_rmsm_popping.png")));
    EXPECT_THAT(walk({"--popping", file("lines"), "--paths", GLIFT_SHADOW_PATHS, "--frames", "1"}).err,
                HasSubstr("at least two frames"));
}

/// A tent from a file, over a floor, in small pictures.
struct ShadowsOfAFile : ShadowsExample {
    ShadowsOfAFile() {
        glift::test::write_file(file("tent.obj"), "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0.5 0.8 0.5\n"
                                                  "f 1 5 2\nf 2 5 3\nf 3 5 4\nf 4 5 1\n");
    }
    glift::test::ProcessResult run_on(const std::string& device, std::vector<std::string> options) {
        const std::vector<std::string> all = {"--scene", file("tent.obj"), "--size", "60",      "40",    "--levels",
                                              "8",       "--pages",        "512",    "--pairs", "20000", "--standard",
                                              "128"};
        options.insert(options.end(), all.begin(), all.end());
        return run_example(GLIFT_SHADOWS, options, {"GLIFT_DEVICE=" + device});
    }
    picture::Picture picture_on(const std::string& device, std::vector<std::string> options) {
        options.insert(options.end(), {"--out", file("out.exr")});
        const auto result = run_on(device, options);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_THAT(result.out, HasSubstr(device == "host" ? "submissions: 0" : "submissions: 1,"));
        return picture::read(file("out.exr"));
    }
    /// The host's picture. Expects that lavapipe's differs from it in at most 1 of 200 pixels.
    picture::Picture on_both(const std::vector<std::string>& options) {
        picture::Picture host = picture_on("host", options);
        EXPECT_LE(different(host, picture_on("lavapipe", options)), 0.005) << testing::PrintToString(options);
        return host;
    }
    /// The share of pixels that differ by more than rounding.
    static double different(const picture::Picture& a, const picture::Picture& b) {
        EXPECT_EQ(a.pixels.size(), b.pixels.size());
        std::size_t number = 0;
        for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i) {
            const glift::float4 &p = a.pixels[i], &q = b.pixels[i];
            const float most = std::max({std::abs(p.x - q.x), std::abs(p.y - q.y), std::abs(p.z - q.z)});
            number += most > 0.02f ? 1 : 0;
        }
        return static_cast<double>(number) / static_cast<double>(a.pixels.size());
    }
};

TEST_F(ShadowsOfAFile, EachViewShowsSomethingElse) {
    std::vector<picture::Picture> all;
    for (const char* view : {"picture", "levels", "borders", "map", "pool"}) {
        all.push_back(on_both({"--show", view}));
        for (std::size_t other = 0; other + 1 < all.size(); ++other)
            EXPECT_GT(different(all.back(), all[other]), 0.01) << view << ' ' << other;
    }
}

TEST_F(ShadowsOfAFile, AdaptiveMapsAgreeWithMatchedOnes) {
    const picture::Picture adaptive = on_both({"--method", "asm", "--seed-level", "4"});
    EXPECT_LE(different(adaptive, picture_on("host", {"--method", "rmsm"})), 0.01);
    EXPECT_GT(different(adaptive, picture_on("host", {"--method", "standard"})), 0.0) << "a map of few texels";
}

TEST_F(ShadowsOfAFile, LightsOfAllKindsCastShadows) {
    const picture::Picture directional = picture_on("host", {});
    for (const char* light : {"spot", "point"}) {
        const picture::Picture lit = on_both({"--light", light});
        EXPECT_GT(different(lit, directional), 0.01) << light;
    }
}

TEST_F(ShadowsOfAFile, ComparesAllMethodsWithRays) {
    for (const char* device : {"host", "lavapipe"}) {
        const auto result = run_on(device, {"--compare", "--out", file("compared.png")});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        const std::string words = "RMSM ";
        const std::size_t at = result.out.find(words);
        ASSERT_NE(at, std::string::npos) << result.out;
        EXPECT_GE(std::stod(result.out.substr(at + words.size())), 99.0) << result.out;
        EXPECT_THAT(result.out, HasSubstr("pixels agree with rays"));
        const picture::Picture compared = picture::read(file("compared.png"));
        EXPECT_GT(compared.width * compared.height, 60u * 40u) << "several pictures side by side";
    }
}

TEST_F(ShadowsExample, SaysWhatIsWrong) {
    std::ofstream(file("path.txt")) << "# a path\n0 1 2 3\n";
    EXPECT_THAT(run({"--path", file("path.txt")}).err, HasSubstr("path.txt:2: has to have 13 numbers"));
    EXPECT_THAT(run({"--pairs", "10", "--out", file("a.png")}).err, HasSubstr("--pairs"));
    EXPECT_THAT(run({"--light", "point", "--pages", "5"}).err, HasSubstr("6 pages by --pages"));
    const std::vector<std::string> levels{"--scene", "robot", "--light", "point", "--levels", "12"};
    EXPECT_THAT(run_example(GLIFT_SHADOWS, levels, {"GLIFT_DEVICE=host"}).err,
                HasSubstr("at most 11 levels by --levels"));
    EXPECT_THAT(run({"--path", file("nowhere.txt")}).err, HasSubstr("nowhere.txt: cannot be read"));
    EXPECT_THAT(walk({"--agreement", file("a"), "--paths", "nowhere"}).err,
                HasSubstr("nowhere/hairball.path: cannot be read"));
    EXPECT_THAT(walk({"--agreement", file("a"), "--paths", GLIFT_SHADOW_PATHS, "--cached"}).err,
                HasSubstr("cannot be kept"));
    EXPECT_THAT(walk({"--agreement", "/nowhere/a"}).err, HasSubstr("/nowhere/a: cannot be written"));
    std::ofstream(file("eye.txt")) << "0 1 2 3 0 0 0 4 7 3 0 1 0\n0 1 2 3 0 0 0 4 7 3 4 7 3\n";
    EXPECT_THAT(run({"--path", file("eye.txt")}).err, HasSubstr("eye.txt:2: an eye is at its target"));
    EXPECT_THAT(run({"--write-path", "/dev/full", "--out", file("a.png")}).err, HasSubstr("cannot be written"));
    for (const char* option : {"--bias", "--time", "--closer", "--light-closer", "--approach", "--up"})
        EXPECT_THAT(run({option, "nan"}).err, HasSubstr("nan is not a finite number")) << option;
    EXPECT_THAT(run({"--out", "a.jpg"}).err, HasSubstr("pictures are .png or .exr files"));
    EXPECT_THAT(run({"--path", file("path.txt"), "--right", "1"}).err, HasSubstr("excludes"));
    EXPECT_THAT(run({"--agreement", file("a")}).err, HasSubstr("excludes"));
    EXPECT_THAT(walk({"--scene", "nowhere"}).err, HasSubstr("there is no scene 'nowhere'"));
}

/// Draws the mesh of a file whose name has no extension, and of a path only as many frames as --frames says.
TEST_F(ShadowsExample, DrawsAFileAlongAPath) {
    std::ofstream(file("mesh")) << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                                   "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                                   "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    ASSERT_EQ(run({"--frames", "4", "--write-path", file("path.txt"), "--out", file("a.png")}).exit_code, 0);
    const auto result =
        walk({"--scene", file("mesh"), "--path", file("path.txt"), "--frames", "2", "--out", file("b.png")});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(std::filesystem::exists(file("b.0001.png")));
    EXPECT_FALSE(std::filesystem::exists(file("b.0002.png")));
}

/// With a standard shadow map, which has no pages, the program says nothing of pages.
TEST_F(ShadowsExample, SaysNothingOfPagesWhereThereAreNone) {
    EXPECT_THAT(run({"--out", file("a.png")}).out, HasSubstr("pages asked for"));
    EXPECT_THAT(run({"--out", file("a.png"), "--method", "standard"}).out, testing::Not(HasSubstr("pages")));
}

/// Where the light moves along the path, --cached, which keeps pages between frames, does not change the pictures.
TEST_F(ShadowsExample, KeepsNoPagesOfALightThatMoves) {
    std::ofstream(file("path.txt")) << "0.4 2.6 2 4.2 0 1 0 4 7 3 0 0.5 0\n0.4 2.6 2 4.2 0 1 0 -4 5 3 0 0.5 0\n";
    ASSERT_EQ(run({"--path", file("path.txt"), "--out", file("a.png")}).exit_code, 0);
    ASSERT_EQ(run({"--path", file("path.txt"), "--out", file("b.png"), "--cached"}).exit_code, 0);
    EXPECT_EQ(glift::test::read_file(file("a.0001.png")), glift::test::read_file(file("b.0001.png")));
}

}  // namespace
