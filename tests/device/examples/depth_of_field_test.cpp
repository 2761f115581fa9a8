// Runs the depth-of-field example as a user does: compares pictures with a direct solution in double precision and
// between devices, and checks what is said where something is wrong.
#include "run_example.h"

#include "examples/common/picture.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace {

using picture::Picture;
using testing::HasSubstr;

struct DepthOfField : testing::Test {
    glift::test::TemporaryFolder folder;
    std::string file(const std::string& name) const { return folder.path() / name; }
    static glift::test::ProcessResult run(const std::string& device, const std::vector<std::string>& arguments) {
        return run_example(GLIFT_DEPTH_OF_FIELD, arguments, {"GLIFT_DEVICE=" + device});
    }
};

/// The diameter in pixels of the circle of confusion at distance z, by the example's default lens with this focus, in a
/// picture of this width.
double circle(double z, double focus, double width) {
    const double focal = 0.05, aperture = 0.025, film = 0.036;
    return width / film * aperture * focal / (focus - focal) * std::abs(focus / z - 1);
}

/// Solves one line of the diffusion, by the Thomas algorithm.
std::vector<double> solved(const std::vector<double>& right, const std::vector<double>& circles) {
    const std::size_t n = right.size();
    const auto flow = [&](std::size_t i) {  // the conductivity between i and i + 1
        const double least = std::min(circles[i], circles[i + 1]);
        return least * least / 32;
    };
    std::vector<double> upper(n), x(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double before = i > 0 ? flow(i - 1) : 0, after = i + 1 < n ? flow(i) : 0;
        const double pivot = 1 + before + after - (i > 0 ? before * upper[i - 1] : 0);
        upper[i] = after / pivot;
        x[i] = (right[i] + (i > 0 ? before * x[i - 1] : 0)) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 0;) x[i] += upper[i] * x[i + 1];
    return x;
}

/// Diffuses a channel along rows, then along columns.
std::vector<double> diffused(const Picture& picture, unsigned channel, double focus) {
    const std::size_t width = picture.width, height = picture.height;
    std::vector<double> values, circles;
    for (std::size_t i = 0; i < width * height; ++i) {
        values.push_back(picture.pixels[i][channel]);
        circles.push_back(circle(picture.depth[i], focus, static_cast<double>(width)));
    }
    const auto along = [&](std::size_t lines, std::size_t length, std::size_t line_step, std::size_t step) {
        for (std::size_t line = 0; line < lines; ++line) {
            std::vector<double> right, widths;
            for (std::size_t i = 0; i < length; ++i) {
                right.push_back(values[line * line_step + i * step]);
                widths.push_back(circles[line * line_step + i * step]);
            }
            const std::vector<double> x = solved(right, widths);
            for (std::size_t i = 0; i < length; ++i) values[line * line_step + i * step] = x[i];
        }
    };
    along(height, width, width, 1);
    along(width, height, 1, width);
    return values;
}

Picture random_picture(std::uint32_t width, std::uint32_t height) {
    Picture made{width, height, {}, {}};
    std::mt19937 random(width * 1000 + height);
    const auto number = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(random()) / 4294967296.0f;
    };
    for (std::uint32_t i = 0; i < width * height; ++i) {
        made.pixels.emplace_back(number(0, 1), number(0, 1), number(0, 1), 1.0f);
        made.depth.push_back(i % 7 == 0 ? 4.0f : number(0.4f, 60));
    }
    return made;
}

TEST_F(DepthOfField, OneLayerIsTheDirectSolution) {
    for (const auto& [width, height] :
         {std::pair(33u, 17u), std::pair(1u, 9u), std::pair(64u, 1u), std::pair(120u, 90u)}) {
        const Picture picture = random_picture(width, height);
        picture::write(file("in.exr"), picture);
        for (const char* device : {"host", "lavapipe"}) {
            const auto result = run(device, {"--colour", file("in.exr"), "--layers", "1", "--out", file("out.exr")});
            ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
            const Picture out = picture::read(file("out.exr"));
            for (unsigned channel = 0; channel < 3; ++channel) {
                const std::vector<double> expected = diffused(picture, channel, 4);
                for (std::size_t i = 0; i < expected.size(); ++i)
                    ASSERT_NEAR(out.pixels[i][channel], expected[i], 1e-4) << device << ' ' << width << ' ' << i;
            }
        }
    }
}

TEST_F(DepthOfField, AllLayersOfASceneAgreeOnBothDevices) {
    for (const char* layers : {"2", "3"}) {
        for (const char* device : {"host", "lavapipe"}) {
            const auto result = run(device, {"--scene", "robot", "--size", "72", "48", "--layers", layers, "--focus",
                                             "3", "--out", file(std::string(device) + ".exr")});
            ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
        }
        const Picture here = picture::read(file("host.exr")), there = picture::read(file("lavapipe.exr"));
        for (std::size_t i = 0; i < here.pixels.size(); ++i)
            for (unsigned k = 0; k < 3; ++k)
                ASSERT_NEAR(here.pixels[i][k], there.pixels[i][k], 1e-3) << layers << ' ' << i;
    }
}

TEST_F(DepthOfField, DrawsAndBlursInOneSubmission) {
    for (const char* layers : {"1", "2", "3"}) {
        const auto result = run("lavapipe", {"--scene", "robot", "--size", "72", "48", "--layers", layers, "--out",
                                             file("a.png"), "--pinhole", file("pinhole.exr")});
        ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
        EXPECT_THAT(result.out, HasSubstr(" and 1 submissions a photograph"));
    }
    const Picture pinhole = picture::read(file("pinhole.exr"));
    const auto [near, far] = std::minmax_element(pinhole.depth.begin(), pinhole.depth.end());
    EXPECT_GT(*near, 1.0f) << "the robot's distance in metres";
    EXPECT_LT(*near, 8.0f);
    EXPECT_GT(*far, 2 * *near);
}

TEST_F(DepthOfField, ShowsCirclesAndLayers) {
    const auto shown = [&](const std::string& what) {
        const auto result =
            run("host", {"--scene", "robot", "--size", "72", "48", "--focus", "5", "--f-stop", "0.2", "--visualise",
                         what, "--pinhole", file("pinhole.exr"), "--out", file(what + ".exr")});
        EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
        return picture::read(file(what + ".exr"));
    };
    const Picture circles = shown("circles"), layers = shown("layers"), pinhole = picture::read(file("pinhole.exr"));
    std::set<unsigned> seen;
    for (std::size_t i = 0; i < circles.pixels.size(); ++i) {
        const float z = pinhole.depth[i];
        ASSERT_NEAR(circles.pixels[i].y, std::min(1.0f, std::abs(5 / z - 1)), 1e-4f) << z;
        const unsigned layer = z < 5 / 1.1f ? 0 : z < 5 / 0.75f ? 1 : 2;
        for (unsigned k = 0; k < 3; ++k)
            ASSERT_NEAR(layers.pixels[i][k], 0.4f * pinhole.pixels[i][k] + (k == layer ? 0.4f : 0.0f), 1e-5f) << z;
        seen.insert(layer);
    }
    EXPECT_EQ(seen.size(), 3u);
}

TEST_F(DepthOfField, IsNearToARealLens) {
    const auto result = run("host", {"--scene", "robot", "--size", "96", "64", "--focus", "3", "--reference", "32",
                                     "--out", file("a.png")});
    ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
    const std::size_t at = result.out.find("lens samples: ");
    ASSERT_NE(at, std::string::npos) << result.out;
    EXPECT_LT(std::stod(result.out.substr(at + 14)), 0.03) << result.out;
    EXPECT_EQ(picture::read(file("a.difference.png")).width, 96u);
}

TEST_F(DepthOfField, SaysWhatIsWrong) {
    const auto refuses = [&](std::vector<std::string> arguments, const std::string& words) {
        const auto result = run("host", std::move(arguments));
        EXPECT_NE(result.exit_code, 0);
        EXPECT_THAT(result.out + result.err, HasSubstr(words));
    };
    refuses({"--focus", "0.02"}, "has to be larger than the focal length");
    refuses({"--scene", "forest"}, "hairball, fence, robot, skeletons, city, trees");
    refuses({"--size", "0", "5"}, "--size");
    Picture flat = random_picture(4, 4);
    flat.depth.clear();
    picture::write(file("flat.exr"), flat);
    refuses({"--colour", file("flat.exr")}, "has no distances (channel Z); name a picture of them with --depth");
    refuses({"--colour", file("flat.exr"), "--reference", "4", "--depth", file("missing.exr")}, "missing.exr");
    refuses({"--colour", file("flat.exr"), "--reference", "4", "--depth", file("flat.exr")},
            "--reference needs a scene");
    refuses({"--colour", file("flat.exr"), "--layers", "3", "--depth", file("flat.exr")}, "needs --foreground");
    refuses({"--out", file("no/folder/a.png"), "--size", "8", "8"}, "cannot be written");
}

}  // namespace
