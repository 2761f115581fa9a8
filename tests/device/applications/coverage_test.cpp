// Compares which pixels rasters (draws declared in Glift) cover on the host device and on Vulkan, under validation:
// triangles, lines, points, whole meshes, and degenerate or huge triangles, which must do no harm.
#include "tests/device/guards/on_every_device.h"

#include "coverage.glift.hpp"
#include "edges.h"

#include "examples/common/camera.h"
#include "examples/common/mesh.h"
#include "examples/common/scenes/scenes.h"

#include <glift/host/math.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <random>

namespace {

using glift::float3;
using glift::float4;
using glift::uint2;

struct Covered {
    std::vector<std::uint32_t> counts, nearest;
};

class Coverage : public testing::Test {
protected:
    glift::Device host = glift::Device::open("host");
    glift::Device vulkan =
        glift::Device::open(std::getenv("GLIFT_TEST_DEVICE") ? std::getenv("GLIFT_TEST_DEVICE") : "lavapipe");
    ~Coverage() override {
        for (const std::string& message : vulkan.validation_messages()) ADD_FAILURE() << message;
    }

    template <class Draw> static std::vector<std::uint32_t> drawn(const glift::Device& device, const Draw& draw,
                                                                  const std::vector<float4>& list, uint2 size) {
        coverage::Places places(device, static_cast<std::uint32_t>(list.size()));
        places.write(list);
        const coverage::Counts counts(device, size);
        draw(device, places, counts);
        return counts.read();
    }
    static std::vector<std::uint32_t> of_places(const glift::Device& device, const std::vector<float4>& list,
                                                uint2 size) {
        return drawn(
            device, [](auto&&... all) { coverage::overdraw(all...); }, list, size);
    }
    /// The pixels whose counts differ between the two devices. Expects fewer than one for each 500 fragments.
    template <class Draw>
    std::vector<uint2> differing(const Draw& draw, const std::vector<float4>& list, uint2 size) const {
        const auto a = drawn(host, draw, list, size), b = drawn(vulkan, draw, list, size);
        std::vector<uint2> differ;
        std::uint64_t fragments = 0;
        for (std::uint32_t i = 0; i < a.size(); ++i) {
            if (a[i] != b[i]) differ.emplace_back(i % size.x, i / size.x);
            fragments += a[i];
        }
        std::printf("%zu places, %llu fragments, %zu pixels differ\n", list.size(),
                    static_cast<unsigned long long>(fragments), differ.size());
        EXPECT_GT(fragments, differ.size() * 500);
        return differ;
    }

    static Covered of_mesh(const glift::Device& device, const mesh::Mesh& mesh, const camera::Camera& view,
                           uint2 size) {
        coverage::Corners corners(device, static_cast<std::uint32_t>(mesh.corners.size()));
        coverage::Points points(device, static_cast<std::uint32_t>(mesh.points.size()));
        corners.write(mesh.corners);
        points.write(mesh.points);
        const coverage::Counts counts(device, size);
        const coverage::Nearest nearest(device, size);
        const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
        coverage::overdraw_mesh(device, corners, points, camera::projection_of(view, aspect), counts, nearest);
        return {counts.read(), nearest.read()};
    }

    /// Expects equal counts of triangles in all pixels, except where clipping explains the difference, and on GPUs also
    /// where the rounding of vertices explains it (edges.h). At most 1 + fragments / 10,000 pixels may differ in all.
    void compare(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b,
                 const std::vector<float4>& places, uint2 size) const {
        std::uint64_t fragments = 0;
        ASSERT_EQ(a.size(), b.size());
        for (const std::uint32_t count : a) fragments += count;
        const bool is_gpu = vulkan.properties().kind == glift::DeviceKind::gpu;
        const edges::Difference found =
            edges::compared(a, b, places, size, is_gpu ? edges::Rule::rounded : edges::Rule::exact);
        for (const uint2& pixel : found.unexplained) {
            const std::uint32_t i = pixel.y * size.x + pixel.x;
            ADD_FAILURE() << "pixel " << pixel.x << ' ' << pixel.y << ": " << a[i] << " and " << b[i];
        }
        EXPECT_LE(found.pixels, 1 + fragments / 10000);
        std::printf("%zu triangles, %llu fragments, %zu pixels differ\n", places.size() / 3,
                    static_cast<unsigned long long>(fragments), found.pixels);
    }

    void same_mesh(const mesh::Mesh& mesh, const camera::Camera& view, uint2 size) const {
        const Covered a = of_mesh(host, mesh, view, size), b = of_mesh(vulkan, mesh, view, size);
        const auto camera = camera::projection_of(view, static_cast<float>(size.x) / static_cast<float>(size.y));
        std::vector<float4> places;
        for (const std::uint32_t corner : mesh.corners) {
            const float3& p = mesh.points[corner];
            places.push_back(camera[0] * p.x + camera[1] * p.y + camera[2] * p.z + camera[3]);
        }
        compare(a.counts, b.counts, places, size);
        std::size_t others = 0, drawn = 0;
        for (std::size_t i = 0; i < a.nearest.size(); ++i) {
            others += a.nearest[i] != b.nearest[i];
            drawn += a.nearest[i] != 0;
        }
        std::printf("%zu pixels show another triangle\n", others);
        EXPECT_GT(drawn, a.nearest.size() / 20);
        // Where depths differ only in their last bits, either triangle may be in front.
        EXPECT_LE(others, a.nearest.size() / 1000);
    }
    void same(const std::vector<float4>& places, uint2 size) const {
        compare(of_places(host, places, size), of_places(vulkan, places, size), places, size);
    }
};

/// Random numbers from a seed.
class Numbers {
public:
    explicit Numbers(unsigned seed) : random_(seed) {}
    float between(float low, float high) { return low + (high - low) * static_cast<float>(random_() >> 8) * 0x1p-24f; }

private:
    std::mt19937 random_;
};

TEST_F(Coverage, OfAHundredThousandTriangles) {
    Numbers number(5);
    std::vector<float4> places;
    for (int i = 0; i < 100000; ++i) {
        const float x = number.between(-1, 1), y = number.between(-1, 1);
        const float size = i % 50 == 0 ? 0.3f : i % 5 == 0 ? 0.05f : 0.008f;
        for (int k = 0; k < 3; ++k) {
            const float w = number.between(0.5f, 2);
            places.emplace_back((x + number.between(-size, size)) * w, (y + number.between(-size, size)) * w,
                                number.between(0.1f, 0.9f) * w, w);
        }
    }
    same(places, {512, 384});
}

void draw_lines(const glift::Device& device, const coverage::Places& places, const coverage::Counts& counts) {
    coverage::lines_over(device, places, counts);
}
void draw_points(const glift::Device& device, const coverage::Places& places, const coverage::Counts& counts) {
    coverage::points_over(device, places, counts);
}

/// Lines of any direction and several lengths, in perspective; horizontal, vertical and diagonal lines from the centre
/// of one pixel to that of another; and lines that leave the view.
TEST_F(Coverage, OfLines) {
    constexpr uint2 size(301, 203);
    Numbers number(11);
    std::vector<float4> inside, grid, across;
    for (int i = 0; i < 20000; ++i) {
        const float length = i % 50 == 0 ? 1.0f : i % 3 == 0 ? 0.1f : 0.01f;
        const float x = number.between(-0.9f, 0.9f), y = number.between(-0.9f, 0.9f);
        for (int k = 0; k < 2; ++k) {
            const float w = number.between(0.5f, 2);
            inside.emplace_back(std::clamp(x + number.between(-length, length), -1.0f, 1.0f) * w,
                                std::clamp(y + number.between(-length, length), -1.0f, 1.0f) * w, 0.5f * w, w);
        }
    }
    constexpr uint2 square(64, 64);  // a size for which the pixels' centres are exact in clip coordinates
    for (int i = 0; i < 2000; ++i) {
        const auto cell = [&] { return std::floor(number.between(0, 63.99f)); };
        const float x = cell(), y = cell(), length = cell();
        const float way_x = i % 4 == 1 ? 0.0f : 1.0f, way_y = i % 4 == 0 ? 0.0f : i % 4 == 3 ? -1.0f : 1.0f;
        const auto at = [&](float column, float row) {
            grid.emplace_back((column + 0.5f) / 32 - 1, (row + 0.5f) / 32 - 1, 0.5f, 1.0f);
        };
        at(x, y);
        at(x + way_x * length, y + way_y * length);
    }
    for (int i = 0; i < 2000; ++i)
        for (int k = 0; k < 2; ++k)
            across.emplace_back(number.between(-5, 5), number.between(-5, 5), number.between(-0.5f, 1.5f),
                                number.between(-0.2f, 2));
    EXPECT_TRUE(differing(draw_lines, grid, square).empty());
    for (const std::vector<float4>& list : {inside, across})
        for (const uint2 pixel : differing(draw_lines, list, size))
            EXPECT_TRUE(edges::is_beside_a_line(list, size, pixel)) << pixel.x << ' ' << pixel.y;
}

TEST_F(Coverage, OfPoints) {
    Numbers number(12);
    std::vector<float4> places, grid;
    for (int i = 0; i < 20000; ++i) {
        const float w = number.between(0.5f, 2);
        places.emplace_back(number.between(-1.1f, 1.1f) * w, number.between(-1.1f, 1.1f) * w,
                            number.between(-0.1f, 1.1f) * w, w);
    }
    // Points at corners, on sides and at centres of pixels.
    for (int i = 0; i <= 128; ++i)
        for (int k = 0; k <= 128; ++k)
            grid.emplace_back(static_cast<float>(i) / 64 - 1, static_cast<float>(k) / 64 - 1, 0.5f, 1.0f);
    EXPECT_TRUE(differing(draw_points, places, {301, 203}).empty());
    EXPECT_TRUE(differing(draw_points, grid, {64, 64}).empty());
}

TEST_F(Coverage, OfScenes) {
    for (const char* name : {"robot", "skeletons", "city", "trees"}) {
        const scenes::Scene scene = scenes::make(name, 0.3f);
        SCOPED_TRACE(name);
        same_mesh(scene.mesh, scene.view, {241, 163});
    }
}

/// Draws a large mesh, if its file exists: in the folder that GLIFT_DATA names, else in shared/data beside the project.
TEST_F(Coverage, OfTheDragon) {
    const char* named = std::getenv("GLIFT_DATA");
    const std::filesystem::path file = std::filesystem::path(named ? named : GLIFT_DATA_BESIDE) / "dragon_vrip.ply.gz";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
    mesh::Mesh mesh = mesh::read(file);
    mesh::normalise(mesh);
    ASSERT_EQ(mesh.triangles(), 871414u);
    const mesh::Box box = mesh::bounds_of(mesh);
    const float3 middle = (box.low + box.high) * 0.5f;
    same_mesh(mesh, {middle + float3(0.9f, 0.35f, 1.3f), middle, float3(0, 1, 0), 0.8f, 0.05f, 5}, {1024, 1024});
}

/// A triangle of one of the kinds that should be harmless: degenerate, with NaN or infinity, with w = 0,
/// invisible or tiny.
std::vector<float4> odd_triangle(unsigned kind, Numbers& number) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    const auto corner = [&](float size, float w) {
        return float4(number.between(-size, size) * w, number.between(-size, size) * w, number.between(0.1f, 0.9f) * w,
                      w);
    };
    std::vector<float4> made{corner(1, 1), corner(1, 1), corner(1, 1)};
    const unsigned k = static_cast<unsigned>(number.between(0, 2.99f));
    switch (kind) {
    case 0: made[1] = made[0]; break;                     // two corners in one place
    case 1: made[2] = (made[0] + made[1]) * 0.5f; break;  // a line
    case 2: made[1] = made[2] = made[0]; break;           // a point
    case 3: made[k].x = nan; break;
    case 4: made[k].w = nan; break;
    case 5: made[k] = float4(nan, nan, nan, nan); break;
    case 6: made[k].y = infinity; break;
    case 7: made[k].z = nan; break;
    case 8: made[k].w = 0; break;
    case 9:
        for (float4& p : made) p.w = -p.w;
        break;  // behind the eye
    case 10:
        for (float4& p : made) p.z = 2;
        break;  // beyond the far plane
    case 11:
        for (float4& p : made) p.z = -1;
        break;  // in front of the near plane
    case 12:
        for (float4& p : made) p = float4(p.x * 1e-30f, p.y * 1e-30f, p.z, p.w);
        break;
    default:
        for (float4& p : made) p = float4(p.x * 0.002f, p.y * 0.002f, p.z, p.w);  // smaller than a pixel
    }
    return made;
}
constexpr unsigned odd_kinds = 14;

TEST_F(Coverage, OfDegenerateTrianglesAndNaNs) {
    for (unsigned kind = 0; kind < odd_kinds; ++kind) {
        Numbers number(kind);
        std::vector<float4> places;
        for (int i = 0; i < 200; ++i)
            for (const float4& place : odd_triangle(kind, number)) places.push_back(place);
        SCOPED_TRACE(kind);
        same(places, {97, 61});
    }
}

/// Triangles some of whose corners are far outside of the window, in front of the near plane, or behind the eye.
TEST_F(Coverage, OfHugeAndClippedTriangles) {
    for (const float reach : {3.0f, 50.0f, 1000.0f, 1e6f, 1e20f, 3e38f}) {
        Numbers number(static_cast<unsigned>(std::log2(static_cast<double>(reach))));
        std::vector<float4> places;
        for (int i = 0; i < 300; ++i) {
            const float w = number.between(0.5f, 2);
            places.emplace_back(number.between(-1, 1) * w, number.between(-1, 1) * w, 0.5f * w, w);
            places.emplace_back(number.between(-reach, reach), number.between(-reach, reach), number.between(-2, 2),
                                number.between(-1, 2));
            places.emplace_back(number.between(-reach, reach), number.between(-1, 1), 0.5f, 1.0f);
        }
        SCOPED_TRACE(reach);
        same(places, {97, 61});
    }
}

/// Draws 20,000 triangles of all kinds of odd_triangle at once: none may disturb those that come after it.
TEST_F(Coverage, OfASoup) {
    Numbers number(99);
    std::vector<float4> places;
    for (int i = 0; i < 20000; ++i) {
        for (const float4& place : odd_triangle(static_cast<unsigned>(i) % odd_kinds, number)) places.push_back(place);
    }
    same(places, {301, 203});
}

}  // namespace
