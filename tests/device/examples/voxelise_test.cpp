// Runs the voxelise example as a user does: it finds as many voxels and pages as exact arithmetic in integers, and the
// pictures of both devices differ in few pixels.
#include "run_example.h"

#include "examples/common/picture.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>

namespace {

using testing::HasSubstr;
using Vector = std::array<std::int64_t, 3>;
using Triangle = std::array<Vector, 3>;

Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
std::int64_t dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Whether `axis` is a separating axis of a triangle and the cube of side 2 around a centre.
bool separates(const Vector& axis, const Triangle& t, const Vector& centre) {
    const std::int64_t reach = std::abs(axis[0]) + std::abs(axis[1]) + std::abs(axis[2]);
    std::int64_t low = INT64_MAX, high = INT64_MIN;
    for (const Vector& corner : t) {
        low = std::min(low, dot(axis, corner - centre));
        high = std::max(high, dot(axis, corner - centre));
    }
    return low > reach || high < -reach;
}

/// Whether a triangle touches a voxel, by the 13 candidates for a separating axis. Lengths are in half voxels, so that
/// nothing is rounded.
bool touches(const Triangle& t, const Vector& centre) {
    const std::array<Vector, 3> edges = {t[1] - t[0], t[2] - t[1], t[0] - t[2]},
                                axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    if (separates(cross(edges[0], edges[1]), t, centre)) return false;
    for (const Vector& axis : axes) {
        if (separates(axis, t, centre)) return false;
        for (const Vector& edge : edges)
            if (separates(cross(axis, edge), t, centre)) return false;
    }
    return true;
}

/// Adds the voxels that a triangle touches. A triangle whose bounding box begins on the upper side of a voxel is not
/// taken to touch that voxel.
void add_touched(const Triangle& t, std::set<Vector>& voxels) {
    Vector low, high;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min({t[0][axis], t[1][axis], t[2][axis]}) / 2;
        high[axis] = std::max({t[0][axis], t[1][axis], t[2][axis]}) / 2;
    }
    for (std::int64_t z = low[2]; z <= high[2]; ++z)
        for (std::int64_t y = low[1]; y <= high[1]; ++y)
            for (std::int64_t x = low[0]; x <= high[0]; ++x)
                if (touches(t, {2 * x + 1, 2 * y + 1, 2 * z + 1})) voxels.insert({x, y, z});
}

/// Small and large triangles with coordinates of 8 to 56 voxels. The first one spans this range along each axis, so
/// that the example, which fits a mesh to it, leaves all as they are.
std::vector<Triangle> random_triangles(std::mt19937& random) {
    std::vector<Triangle> triangles = {{{{16, 16, 16}, {112, 20, 30}, {40, 112, 112}}}};
    while (triangles.size() < 60) {
        Triangle t;
        const std::int64_t reach = triangles.size() % 4 == 0 ? 96 : 9;
        Vector from;
        for (std::int64_t& x : from) x = 16 + static_cast<std::int64_t>(random() % 97);
        for (Vector& corner : t)
            for (std::size_t axis = 0; axis < 3; ++axis)
                corner[axis] = std::clamp<std::int64_t>(
                    from[axis] + static_cast<std::int64_t>(random() % (2 * reach + 1)) - reach, 16, 112);
        if (cross(t[1] - t[0], t[2] - t[0]) != Vector{}) triangles.push_back(t);
    }
    return triangles;
}

struct Voxelise : testing::Test {
    glift::test::TemporaryFolder folder;

    glift::test::ProcessResult run(const std::string& device, std::vector<std::string> options) {
        const std::vector<std::string> all = {"--extent", "64",           "--size", "96",    "--pages",
                                              "512",      "--tree-pages", "1024",   "--out", folder.path() / device};
        options.insert(options.end(), all.begin(), all.end());
        return run_example(GLIFT_VOXELISE, options, {"GLIFT_DEVICE=" + device});
    }

    std::string written(const std::vector<Triangle>& triangles) {
        const std::string file = folder.path() / "triangles.obj";
        std::ofstream out(file);
        for (const Triangle& t : triangles)
            for (const Vector& corner : t)
                out << "v " << 0.5 * double(corner[0]) << ' ' << 0.5 * double(corner[1]) << ' '
                    << 0.5 * double(corner[2]) << '\n';
        for (std::size_t i = 0; i < triangles.size(); ++i)
            out << "f " << 3 * i + 1 << ' ' << 3 * i + 2 << ' ' << 3 * i + 3 << '\n';
        return file;
    }
};

TEST_F(Voxelise, TouchesWhatTrianglesTouch) {
    std::mt19937 random(7);
    const std::vector<Triangle> triangles = random_triangles(random);
    std::set<Vector> voxels, pages;
    for (const Triangle& t : triangles) add_touched(t, voxels);
    for (const Vector& v : voxels) pages.insert({v[0] / 8, v[1] / 8, v[2] / 8});
    const std::string wanted = "60 triangles in 64^3: " + std::to_string(voxels.size()) + " voxels in " +
                               std::to_string(pages.size()) + " pages";
    const std::string file = written(triangles);
    for (const std::string device : {"host", "lavapipe"}) {
        const auto result = run(device, {file});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        EXPECT_THAT(result.out, HasSubstr(wanted)) << device;
        if (device == "lavapipe") {
            EXPECT_THAT(result.out, testing::ContainsRegex("submissions: 1\noctree.*submissions: 1\n"));
        }
    }
}

TEST_F(Voxelise, LooksTheSameOnBothDevices) {
    for (const std::string device : {"host", "lavapipe"}) {
        const auto result = run(device, {"robot", "--inspect"});
        ASSERT_EQ(result.exit_code, 0) << result.err;
    }
    for (const std::string name : {"voxels_pages.inspection", "distances_pages.inspection"}) {
        const auto elements_on = [&](const std::string& device) {
            const std::string text = glift::test::read_file(folder.path() / device / name);
            EXPECT_THAT(text, HasSubstr("\"planes\""));
            return text.substr(text.find("\"elements\""), 20);
        };
        EXPECT_EQ(elements_on("host"), elements_on("lavapipe"));
    }
    for (const std::string name : {"voxels.png", "voxels_slice.png", "distances.png", "distances_slice.png"}) {
        const std::filesystem::path out = folder.path();
        const picture::Picture a = picture::read(out / "host" / name), b = picture::read(out / "lavapipe" / name);
        ASSERT_EQ(a.pixels.size(), b.pixels.size());
        std::size_t differ = 0, empty = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            differ += std::abs(a.pixels[i].x - b.pixels[i].x) > 0.05f;
            empty += a.pixels[i].x == a.pixels[0].x;
        }
        EXPECT_LE(differ, a.pixels.size() / 200) << name;
        EXPECT_LT(empty, a.pixels.size() * 97 / 100) << name;
    }
}

TEST_F(Voxelise, SaysWhenThePoolIsTooSmall) {
    const auto result = run_example(GLIFT_VOXELISE, {"robot", "--extent", "64", "--pages", "3", "--out", folder.path()},
                                    {"GLIFT_DEVICE=host"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr("--pages"));
}

}  // namespace
