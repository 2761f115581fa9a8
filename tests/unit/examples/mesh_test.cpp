#include "examples/common/mesh.h"
#include "examples/common/shapes.h"
#include "support/process.h"

#include <glift/host/math.h>

#include <gmock/gmock.h>
#include <zlib.h>

#include <cmath>

namespace {

using glift::float3;
using mesh::Mesh;

const std::string square = R"(ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 2
property list uchar int vertex_indices
end_header
0 0 1
2 0 1
2 4 1
0 4 1
3 0 1 2
3 0 2 3
)";

TEST(Mesh, IsReadFromFiles) {
    const glift::test::TemporaryFolder folder;
    const std::string ply = folder.path() / "square.ply", packed = folder.path() / "square.ply.gz",
                      obj = folder.path() / "quad.obj";
    glift::test::write_file(ply, square);
    gzFile file = gzopen(packed.c_str(), "wb");
    gzwrite(file, square.data(), static_cast<unsigned>(square.size()));
    gzclose(file);
    glift::test::write_file(obj, "v 0 0 1\nv 2 0 1\nv 2 4 1\nv 0 4 1\nf 1 2 3 4\n");
    for (const std::string& path : {ply, packed, obj}) {
        const Mesh mesh = mesh::read(path);
        EXPECT_EQ(mesh.triangles(), 2u) << path;
        EXPECT_EQ(mesh.points.size(), 4u) << path;
        EXPECT_EQ(mesh.colours.size(), 4u) << path;
        const mesh::Box box = mesh::bounds_of(mesh);
        EXPECT_EQ(box.low, float3(0, 0, 1)) << path;
        EXPECT_EQ(box.high, float3(2, 4, 1)) << path;
    }
}

TEST(Mesh, SaysWhatIsWrong) {
    const glift::test::TemporaryFolder folder;
    const std::string bad = folder.path() / "bad.ply", points = folder.path() / "points.obj";
    glift::test::write_file(bad, "no mesh");
    glift::test::write_file(points, "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    for (const std::string& path :
         {bad, points, (folder.path() / "missing.ply").string(), (folder.path() / "missing.ply.gz").string()}) {
        try {
            mesh::read(path);
            ADD_FAILURE() << path << " was read";
        } catch (const std::runtime_error& error) {
            EXPECT_THAT(error.what(), testing::StartsWith(path + ": "));
        }
    }
}

/// The error of mesh::read for a file with these bytes; empty if the file is read.
std::string refused(const std::string& name, const std::string& bytes) {
    const glift::test::TemporaryFolder folder;
    glift::test::write_file(folder.path() / name, bytes);
    try {
        mesh::read(folder.path() / name);
        return {};
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

// Assimp reads such faces, and other steps of it crash.
TEST(Mesh, CornersThatAreNotInTheFileAreErrors) {
    for (const char* corner : {"99", "-1"}) {
        const std::string error = refused("bad.ply", replaced(square, "3 0 2 3", std::string("3 0 2 ") + corner));
        EXPECT_THAT(error, testing::HasSubstr("bad.ply: cannot be read as a mesh")) << corner;
    }
    // In a binary file that ends too early, corners are what memory holds.
    std::string binary = replaced(square.substr(0, square.find("0 0 1")), "ascii", "binary_little_endian");
    const float points[] = {0, 0, 1, 2, 0, 1, 2, 4, 1, 0, 4, 1};
    binary.append(reinterpret_cast<const char*>(points), sizeof points);
    EXPECT_NE(refused("cut.ply", binary), "");
}

TEST(Mesh, IsRefusedWhereItIsTruncated) {
    const glift::test::TemporaryFolder folder;
    const std::string packed = folder.path() / "a.obj.gz";
    std::string text;
    for (unsigned i = 0; i < 3000; ++i)  // the lines that are left after a cut are still a mesh
        text +=
            "v " + std::to_string(i * 7919 % 1009) + " " + std::to_string(i) + " 0\n" +
            (i < 2 ? "" : "f " + std::to_string(i - 1) + " " + std::to_string(i) + " " + std::to_string(i + 1) + "\n");
    gzFile file = gzopen(packed.c_str(), "wb");
    gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
    gzclose(file);
    const std::string whole = glift::test::read_file(packed);
    EXPECT_EQ(refused("a.obj.gz", whole), "");
    for (const std::size_t less : {std::size_t{1}, std::size_t{8}, whole.size() / 3, whole.size() / 2})
        EXPECT_THAT(refused("a.obj.gz", whole.substr(0, whole.size() - less)), testing::HasSubstr("is truncated"))
            << less;
}

TEST(Mesh, IsRefusedWhereACornerIsNoPlace) {
    EXPECT_THAT(refused("a.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"), testing::HasSubstr("is not finite"));
    EXPECT_THAT(refused("a.obj", "v 0 0 0\nv 1 0 1e60\nv 0 1 0\nf 1 2 3\n"), testing::HasSubstr("is not finite"));
    EXPECT_THAT(refused("a.obj", "v -3e38 0 0\nv 3e38 0 0\nv 0 1 0\nf 1 2 3\n"), testing::HasSubstr("is too large"));
}

TEST(Mesh, HasTheBoundsOfItsTriangles) {
    Mesh made;
    made.points = {{1000, -1000, 3}, {0, 0, 1}, {2, 0, 1}, {2, 4, 1}, {500, 0, 0}};
    made.corners = {1, 2, 3};
    EXPECT_EQ(mesh::bounds_of(made).low, float3(0, 0, 1));
    EXPECT_EQ(mesh::bounds_of(made).high, float3(2, 4, 1));
    mesh::normalise(made);
    EXPECT_EQ(made.points[3], float3(0.5f, 1, 0));
}

TEST(Mesh, IsNormalisedAlongItsLongestSide) {
    Mesh box;
    mesh::add_box(box, float3(-3, 10, 2), float3(1, 12, 3), float3(1, 1, 1));
    mesh::normalise(box);
    const mesh::Box bounds = mesh::bounds_of(box);
    EXPECT_EQ(bounds.low, float3(0, 0, 0));
    EXPECT_EQ(bounds.high, float3(1, 0.5f, 0.25f));
    Mesh nothing;
    mesh::normalise(nothing);
    EXPECT_EQ(mesh::bounds_of(nothing).high, float3(0, 0, 0));
}

/// Six times the volume that a closed surface encloses: positive if its triangles are counter-clockwise from outside.
float sixfold_volume(const Mesh& mesh) {
    float sum = 0;
    for (std::size_t i = 0; i < mesh.corners.size(); i += 3) {
        const auto point = [&](std::size_t k) { return mesh.points[mesh.corners[i + k]]; };
        sum += glift::dot(point(0), glift::cross(point(1), point(2)));
    }
    return sum;
}

TEST(Shapes, FaceOutwards) {
    Mesh box, rod, level, ball;
    mesh::add_box(box, float3(1, 2, 3), float3(2, 4, 6), float3(1, 1, 1));
    EXPECT_NEAR(sixfold_volume(box), 6 * 6, 1e-3f);
    mesh::add_rod(rod, float3(0, 0, 0), float3(0, 3, 0), 1, 1, 4, float3(1, 1, 1));
    EXPECT_NEAR(sixfold_volume(rod), 6 * 2 * 3, 1e-3f);
    mesh::add_rod(level, float3(5, 1, 1), float3(7, 1, 2), 0.5f, 0.25f, 9, float3(1, 1, 1));
    EXPECT_GT(sixfold_volume(level), 1);
    mesh::add_sphere(ball, float3(1, 2, 3), 2, 40, float3(1, 1, 1));
    EXPECT_NEAR(sixfold_volume(ball), 6 * 4.0f / 3 * 3.1416f * 8, 2);
}

}  // namespace
