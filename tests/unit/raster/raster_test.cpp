// Compares the rasteriser's coverage with exact integer arithmetic, and its interpolation and clipping with double
// precision. Also the order of triangles, culling, depth tests, clip distances, quads, and vertices whose
// coordinates are NaN or infinite.
#include <glift/host/raster.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace {

using namespace glift;
using namespace glift::host;

struct Corner {
    float x, y, z, w;
};

/// Draws vertices given in clip coordinates. Varyings: the number of the triangle (flat), and a value (smooth).
struct Scene {
    std::vector<Corner> corners;
    std::vector<float> values;  ///< each vertex's smooth varying; empty: zeros
    std::function<void(const Fragments&, int pixel)> fragment;
    std::function<void(const Fragments&)> block = nullptr;

    static void run_vertices(const void* body, std::uint64_t first, std::uint32_t count, std::uint32_t, float* out) {
        const Scene& scene = *static_cast<const Scene*>(body);
        for (std::uint64_t i = first; i < first + count; ++i) {
            const Corner& corner = scene.corners[i];
            for (float number : {corner.x, corner.y, corner.z, corner.w, static_cast<float>(i / 3),
                                 scene.values.empty() ? 0.0f : scene.values[i]})
                *out++ = number;
        }
    }
    static void run_fragments(const void* body, const Fragments& fragments) {
        const Scene& scene = *static_cast<const Scene*>(body);
        if (scene.block) scene.block(fragments);
        for (std::uint64_t left = fragments.covered; left != 0; left &= left - 1)
            scene.fragment(fragments, std::countr_zero(left));
    }
    Draw draw(uint2 viewport) const {
        Draw draw;
        draw.body = this;
        draw.vertex = run_vertices;
        draw.fragment = run_fragments;
        draw.corners = corners.size();
        draw.varyings = 2;
        draw.viewport = viewport;
        draw.has_smooth = true;
        return draw;
    }
};

int2 pixel_of(const Fragments& fragments, int pixel) { return fragments.first + int2(pixel % 8, pixel / 8); }

/// The clip coordinates of a point in window coordinates.
Corner at_window(uint2 viewport, double x, double y, float z = 0.5f, float w = 1.0f) {
    const double across = viewport.x, down = viewport.y;
    return {static_cast<float>((2 * x / across - 1) * w), static_cast<float>((2 * y / down - 1) * w), z * w, w};
}

/// A vertex's coordinates in 1/256 of a pixel from the first pixel's centre, by the rasteriser's formula.
std::array<std::int64_t, 2> snapped(uint2 viewport, const Corner& corner) {
    const auto snap = [](float ndc, uint size) {
        const float half = 0.5f * static_cast<float>(size);
        return std::llrint(static_cast<double>(ndc * half + half - 0.5f) * 256);
    };
    return {snap(corner.x * (1.0f / corner.w), viewport.x), snap(corner.y * (1.0f / corner.w), viewport.y)};
}

/// Whether a triangle covers a pixel, by exact arithmetic and the top-left rule.
bool covers(std::array<std::array<std::int64_t, 2>, 3> p, std::int64_t x, std::int64_t y) {
    const auto cross = [](const auto& a, const auto& b, std::int64_t px, std::int64_t py) {
        return (b[0] - a[0]) * (py - a[1]) - (b[1] - a[1]) * (px - a[0]);
    };
    const std::int64_t area = cross(p[0], p[1], p[2][0], p[2][1]);
    if (area == 0) return false;
    if (area < 0) std::swap(p[1], p[2]);
    for (int i = 0; i < 3; ++i) {
        const auto &a = p[static_cast<std::size_t>(i)], &b = p[static_cast<std::size_t>((i + 1) % 3)];
        const std::int64_t value = cross(a, b, 256 * x, 256 * y);
        const bool is_top = a[1] == b[1] && b[0] > a[0], is_left = b[1] < a[1];
        if (value < 0 || (value == 0 && !is_top && !is_left)) return false;
    }
    return true;
}

TEST(Raster, CoverageIsExact) {
    const uint2 viewport(201, 117);
    std::mt19937 random(7);
    Scene scene;
    const double sizes[] = {0.3, 1.5, 9, 60, 400, 12000};
    for (int i = 0; i < 600; ++i) {
        const double size = sizes[i % 6];
        const auto number = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
        const double x = number(-20, 220), y = number(-20, 140);
        for (int k = 0; k < 3; ++k) {
            double px = x + number(-size, size), py = y + number(-size, size);
            if (i % 4 == 0)
                px = std::floor(px) + 0.5, py = std::floor(py) + 0.5;  // on pixel centres, for the top-left rule
            scene.corners.push_back(at_window(viewport, px, py));
        }
    }
    std::vector<std::atomic<int>> covered(600 * 201 * 117);
    scene.fragment = [&](const Fragments& f, int i) {
        const int2 p = pixel_of(f, i);
        ++covered[(static_cast<std::size_t>(f.corner[0][0]) * 117 + static_cast<std::size_t>(p.y)) * 201 +
                  static_cast<std::size_t>(p.x)];
    };
    draw(scene.draw(viewport));
    std::size_t wrong = 0, all = 0;
    for (std::size_t t = 0; t < 600; ++t) {
        std::array<std::array<std::int64_t, 2>, 3> points;
        for (std::size_t k = 0; k < 3; ++k) points[k] = snapped(viewport, scene.corners[3 * t + k]);
        for (std::size_t y = 0; y < 117; ++y)
            for (std::size_t x = 0; x < 201; ++x) {
                const int expected = covers(points, static_cast<std::int64_t>(x), static_cast<std::int64_t>(y));
                all += static_cast<std::size_t>(expected);
                wrong += covered[(t * 117 + y) * 201 + x] != expected;
            }
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(all, 40000u);
}

TEST(Raster, TrianglesOfAMeshCoverEachPixelOnce) {
    const uint2 viewport(640, 480);
    std::mt19937 random(3);
    const int columns = 97, rows = 61;
    std::vector<Corner> points;
    for (int y = 0; y <= rows; ++y)
        for (int x = 0; x <= columns; ++x) {
            const bool is_side = x == 0 || y == 0 || x == columns || y == rows;
            const double jitter = is_side ? 0 : 0.45;
            const auto number = [&] { return jitter * (random() / 2147483648.0 - 1); };
            points.push_back(at_window(viewport, (x + number()) * 640.0 / columns, (y + number()) * 480.0 / rows));
        }
    Scene scene;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const int a = y * (columns + 1) + x, b = a + 1, c = a + columns + 1, d = c + 1;
            for (int corner : {a, b, c, b, d, c}) scene.corners.push_back(points[static_cast<std::size_t>(corner)]);
        }
    std::vector<std::atomic<int>> count(640 * 480);
    scene.fragment = [&](const Fragments& f, int i) {
        const int2 p = pixel_of(f, i);
        ++count[static_cast<std::size_t>(p.y * 640 + p.x)];
    };
    draw(scene.draw(viewport));
    // Vertices are moved so far that some triangles overlap: some pixels belong to several triangles, but each pixel
    // belongs to at least one.
    const auto once = std::count_if(count.begin(), count.end(), [](const auto& n) { return n == 1; });
    EXPECT_EQ(std::count_if(count.begin(), count.end(), [](const auto& n) { return n == 0; }), 0);
    EXPECT_GT(once, 640 * 480 - 2000);
}

TEST(Raster, PixelsSeeTrianglesInOrder) {
    const uint2 viewport(100, 100);
    Scene scene;
    const int triangles = 100000;  // more than one batch
    for (int i = 0; i < triangles; ++i) {
        const double x = i * 37 % 90, y = i * 53 % 90;
        for (const auto& [dx, dy] : {std::pair(0, 0), std::pair(12, 1), std::pair(3, 11)})
            scene.corners.push_back(at_window(viewport, x + dx, y + dy));
    }
    std::vector<float> last(100 * 100, -1.0f);
    std::atomic<int> disorder = 0;
    scene.fragment = [&](const Fragments& f, int i) {
        const int2 p = pixel_of(f, i);
        float& number = last[static_cast<std::size_t>(p.y * 100 + p.x)];
        disorder += f.corner[0][0] < number;
        number = f.corner[0][0];
    };
    draw(scene.draw(viewport));
    EXPECT_EQ(disorder, 0);
}

TEST(Raster, SmoothValuesAreCorrectInPerspective) {
    const uint2 viewport(300, 200);
    Scene scene;
    scene.corners = {at_window(viewport, 10, 10, 0.1f, 1.0f), at_window(viewport, 290, 30, 0.5f, 9.0f),
                     at_window(viewport, 60, 190, 0.9f, 3.0f)};
    scene.values = {0.0f, 1.0f, 5.0f};
    double worst = 0, worst_depth = 0;
    int seen = 0;
    scene.fragment = [&](const Fragments& f, int i) {
        const int2 p = pixel_of(f, i);
        const auto a = snapped(viewport, scene.corners[0]), b = snapped(viewport, scene.corners[1]),
                   c = snapped(viewport, scene.corners[2]);
        const auto cross = [](double ax, double ay, double bx, double by) { return ax * by - ay * bx; };
        const double x = p.x * 256.0, y = p.y * 256.0;
        const double area = cross(double(b[0] - a[0]), double(b[1] - a[1]), double(c[0] - a[0]), double(c[1] - a[1]));
        const double l1 = cross(x - double(a[0]), y - double(a[1]), double(c[0] - a[0]), double(c[1] - a[1])) / area;
        const double l2 = cross(double(b[0] - a[0]), double(b[1] - a[1]), x - double(a[0]), y - double(a[1])) / area;
        const double l0 = 1 - l1 - l2;
        const double exact = (l1 * 1.0 / 9.0 + l2 * 5.0 / 3.0) / (l0 / 1.0 + l1 / 9.0 + l2 / 3.0);
        const float v0 = f.corner[0][1], v1 = f.corner[1][1], v2 = f.corner[2][1];
        worst = std::max(worst, std::abs(exact - (v0 + f.smooth1[i] * (v1 - v0) + f.smooth2[i] * (v2 - v0))));
        worst_depth = std::max(worst_depth, std::abs(l0 * 0.1 + l1 * 0.5 + l2 * 0.9 - f.depth[i]));
        ++seen;
    };
    draw(scene.draw(viewport));
    EXPECT_GT(seen, 10000);
    EXPECT_LT(worst, 1e-5);
    EXPECT_LT(worst_depth, 1e-6);
}

/// A plane close to the eye, whose triangles have parts behind the eye, in front of the near plane and far outside of
/// the view.
TEST(Raster, WhatReachesBehindTheEyeIsClipped) {
    const uint2 viewport(160, 120);
    // A floor at y = 1 below the eye, which looks along z: clip = (x, 1, z - 0.1, z).
    Scene scene;
    const auto floor = [](float x, float z) { return Corner{x, 1.0f, z - 0.1f, z}; };
    const float far = 50.0f, wide = 1000.0f;
    scene.corners = {floor(-wide, -far), floor(wide, -far), floor(wide, far),
                     floor(-wide, -far), floor(wide, far),  floor(-wide, far)};
    scene.values = {-far, -far, far, -far, far, far};
    std::vector<int> count(160 * 120);
    double worst = 0;
    scene.fragment = [&](const Fragments& f, int i) {
        const int2 p = pixel_of(f, i);
        ++count[static_cast<std::size_t>(p.y * 160 + p.x)];
        const double ndc = 2 * (p.y + 0.5) / 120 - 1, z = 1 / ndc;
        const float v0 = f.corner[0][1], v1 = f.corner[1][1], v2 = f.corner[2][1];
        const double found = v0 + f.smooth1[i] * (v1 - v0) + f.smooth2[i] * (v2 - v0);
        worst = std::max(worst, std::abs(found - z) / z);
    };
    Draw all = scene.draw(viewport);
    draw(all);
    for (int y = 0; y < 120; ++y) {
        const double ndc = 2 * (y + 0.5) / 120 - 1;
        const bool is_floor = ndc > 1 / far;  // whether the row is below the floor's far end
        const double beside = std::abs(ndc - 1 / far) * 60;
        for (int x = 0; beside > 0.02 && x < 160; ++x)
            ASSERT_EQ(count[static_cast<std::size_t>(y * 160 + x)], is_floor) << x << ' ' << y;
    }
    EXPECT_LT(worst, 2e-3);
}

TEST(Raster, ClipDistancesCut) {
    const uint2 viewport(64, 64);
    struct Body {
        std::vector<int> count = std::vector<int>(64 * 64);
    } body;
    Draw half;
    half.body = &body;
    half.vertex = [](const void*, std::uint64_t first, std::uint32_t count, std::uint32_t, float* out) {
        const Corner corners[] = {{-1, -1, 0, 1}, {3, -1, 0, 1}, {-1, 3, 0, 1}};
        for (std::uint64_t i = first; i < first + count; ++i)
            for (float number : {corners[i].x, corners[i].y, 0.5f, 1.0f, corners[i].x + corners[i].y}) *out++ = number;
    };
    half.fragment = [](const void* body, const Fragments& f) {
        for (std::uint64_t left = f.covered; left != 0; left &= left - 1) {
            const int2 p = pixel_of(f, std::countr_zero(left));
            ++const_cast<Body*>(static_cast<const Body*>(body))->count[static_cast<std::size_t>(p.y * 64 + p.x)];
        }
    };
    half.corners = 3;
    half.clip_distances = 1;
    half.viewport = viewport;
    draw(half);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            if (x + y != 63) {
                ASSERT_EQ(body.count[static_cast<std::size_t>(y * 64 + x)], x + y > 63) << x << ' ' << y;
            }
}

TEST(Raster, FacesAreCulled) {
    const uint2 viewport(32, 32);
    Scene scene;
    // Counter-clockwise in the window, whose y points down: a front face.
    scene.corners = {at_window(viewport, 0, 0), at_window(viewport, 0, 32), at_window(viewport, 32, 0)};
    int fragments = 0, fronts = 0;
    scene.fragment = [&](const Fragments& f, int) { ++fragments, fronts += f.is_front; };
    Draw one = scene.draw(viewport);
    draw(one);
    EXPECT_EQ(fragments, fronts);
    EXPECT_GT(fragments, 400);
    one.cull = Cull::front;
    draw(one);
    EXPECT_EQ(fragments, fronts);
    const int before = fragments;
    std::swap(scene.corners[0], scene.corners[1]);
    draw(one);
    EXPECT_GT(fragments, before);
    EXPECT_EQ(fronts, before);
    one.cull = Cull::back;
    const int both = fragments;
    draw(one);
    EXPECT_EQ(fragments, both);
}

TEST(Raster, DepthIsTestedAndWritten) {
    const uint2 viewport(40, 24);
    const auto drawn = [&](DepthTest test, bool is_written, bool is_early, float z) {
        std::vector<float> texels(40 * 24, 0.5f);
        Scene scene;
        scene.corners = {at_window(viewport, 0, 0, z), at_window(viewport, 90, 0, z), at_window(viewport, 0, 90, z)};
        std::atomic<int> passed = 0;
        scene.fragment = [](const Fragments&, int) {};
        scene.block = [&](const Fragments& f) { passed += std::popcount(f.test(f.covered)); };
        Draw one = scene.draw(viewport);
        one.depth = {texels.data(), 40, test, is_written, is_early};
        draw(one);
        const auto changed = std::count_if(texels.begin(), texels.end(), [](float t) { return t != 0.5f; });
        return std::pair(passed.load(), static_cast<int>(changed));
    };
    const int all = 40 * 24;
    for (bool early : {true, false}) {
        EXPECT_EQ(drawn(DepthTest::less, true, early, 0.25f), std::pair(all, all));
        EXPECT_EQ(drawn(DepthTest::less, false, early, 0.25f), std::pair(all, 0));
        EXPECT_EQ(drawn(DepthTest::less, true, early, 0.5f), std::pair(0, 0));
        EXPECT_EQ(drawn(DepthTest::less_equal, true, early, 0.5f), std::pair(all, 0));
        EXPECT_EQ(drawn(DepthTest::greater, true, early, 0.75f), std::pair(all, all));
        EXPECT_EQ(drawn(DepthTest::greater, true, early, 0.25f), std::pair(0, 0));
        EXPECT_EQ(drawn(DepthTest::equal, true, early, 0.5f), std::pair(all, 0));
        EXPECT_EQ(drawn(DepthTest::always, true, early, 0.75f), std::pair(all, all));
    }
}

TEST(Raster, QuadsAreThoseOfTheFramebuffer) {
    for (uint shift : {0u, 1u}) {
        Scene scene;
        const uint2 viewport(30, 30);
        scene.corners = {at_window(viewport, 0, 0), at_window(viewport, 70, 0), at_window(viewport, 0, 70)};
        std::atomic<int> odd = 0, all = 0;
        scene.fragment = [&](const Fragments& f, int i) {
            const int2 p = pixel_of(f, i);
            ++all;
            odd += p.x < 0 || p.y < 0 || p.x >= 30 || p.y >= 30 || (f.first.x + static_cast<int>(shift)) % 8 != 0;
        };
        Draw one = scene.draw(viewport);
        one.framebuffer = uint2(6, 6) + uint2(shift, shift);
        draw(one);
        EXPECT_EQ(odd, 0);
        EXPECT_EQ(all, 900);
    }
}

TEST(Raster, NothingComesOfNumbersThatAreNone) {
    Scene scene;
    const uint2 viewport(16, 16);
    const float nan = NAN, infinite = INFINITY;
    for (const Corner& corner : {Corner{nan, 0, 0, 1}, Corner{0, 0, nan, 1}, Corner{0, 0, 0, 0}, Corner{0, 0, 0, -1},
                                 Corner{infinite, 0, 0, 1}, Corner{0, 0, 0, nan}})
        for (const Corner& other : {corner, at_window(viewport, 16, 0), at_window(viewport, 0, 16)})
            scene.corners.push_back(other);
    scene.corners.push_back(at_window(viewport, 0, 0));  // an incomplete triangle
    std::atomic<int> wrong = 0;
    scene.fragment = [&](const Fragments& f, int i) {
        const int2 p = pixel_of(f, i);
        wrong += p.x < 0 || p.y < 0 || p.x >= 16 || p.y >= 16 || !std::isfinite(f.depth[i]);
    };
    draw(scene.draw(viewport));
    EXPECT_EQ(wrong, 0);
    scene.fragment = [&](const Fragments&, int) { ++wrong; };
    draw(scene.draw(uint2(0, 0)));
    EXPECT_EQ(wrong, 0);
}

}  // namespace
