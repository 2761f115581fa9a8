// Octree 3-D paint: what a stroke leaves, pictures as brushes, views of the octree's memory.
#include "paint_model.h"
#include "support/process.h"
#include "tests/device/guards/on_every_device.h"

#include "examples/common/png.h"

#include <gmock/gmock.h>

#include <glift/host/math.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace paint_model;
using glift::float2;
using glift::float3;
using strokes::Stroke;
using testing::HasSubstr;

struct PaintBrush : OnEveryDevice {
    glift::test::TemporaryFolder folder;
    std::string file(const char* name) const { return folder.path() / name; }
};
GLIFT_ON_EVERY_DEVICE(PaintBrush);

/// A square at z = 0.25 that fills the picture's middle, seen from the front.
mesh::Mesh square() {
    mesh::Mesh made;
    made.points = {{0, 0, 0.25f}, {1, 0, 0.25f}, {1, 1, 0.25f}, {0, 1, 0.25f}};
    made.corners = {0, 1, 2, 0, 2, 3};
    return made;
}

struct Range {
    double low = 2, high = -1;
};

/// The smallest and the largest value of a component of colours, of all painted texels.
Range range_of(const State& state, unsigned component) {
    Range range;
    const Field field(state, 4);
    for (const auto& [page, texels] : field.pages())
        for (Word i = 0; i < texels->size(); ++i) {
            const Field::Colour c = field.texel(page, {i % 17, i / 17 % 17, i / 289});
            if (c[3] == 0) continue;
            range.low = std::min(range.low, c[component]);
            range.high = std::max(range.high, c[component]);
        }
    return range;
}

/// The stroke goes right, back and right again. Its brush gets smaller and paints finer pages over coarser ones.
TEST_P(PaintBrush, StopsAtItsOpacity) {
    OctreeSize size = small();
    size.ground = {0.6f, 0.8f, 0.2f};
    Canvas canvas(device, square(), size);
    Stroke stroke = paint_model::one_dab();
    stroke.brush.opacity = 0.5f;
    stroke.path = {{float2(60, 100), 1}, {float2(140, 100), 0.9f}, {float2(60, 100), 0.2f}, {float2(140, 100), 0.1f}};
    const float3 ground = size.ground;
    float3 before = ground;
    for (unsigned round = 0; round < 2; ++round) {
        EXPECT_EQ(canvas.paint(stroke), 0u);
        const float3 end = before + (stroke.brush.colour - before) * 0.5f;
        const State state = state_of(canvas);
        const double step = 1.0 / 255;
        const Range red = range_of(state, 0), green = range_of(state, 1), blue = range_of(state, 2);
        EXPECT_NEAR(red.high, static_cast<double>(end.x), 2 * step) << round;
        EXPECT_NEAR(green.low, static_cast<double>(end.y), 2 * step) << round;
        EXPECT_GE(red.low, static_cast<double>(ground.x) - step);
        EXPECT_LE(green.high, static_cast<double>(ground.y) + step);
        EXPECT_NEAR(blue.high, 0.2, step);
        before = end;
    }
}

TEST_P(PaintBrush, MultipliesOnceAStroke) {
    OctreeSize size = small();
    size.ground = {0.8f, 0.8f, 0.8f};
    Canvas canvas(device, square(), size);
    Stroke stroke = paint_model::one_dab();
    stroke.brush.colour = {0.5f, 1, 1};
    stroke.brush.blend = 1;
    stroke.brush.flow = 1;
    stroke.path = {{float2(60, 100), 1}, {float2(140, 100), 1}, {float2(60, 100), 1}};
    canvas.paint(stroke);
    EXPECT_NEAR(range_of(state_of(canvas), 0).low, 0.4, 1.0 / 255);
    canvas.paint(stroke);
    EXPECT_NEAR(range_of(state_of(canvas), 0).low, 0.2, 1.0 / 255);
}

TEST_P(PaintBrush, IsAPicture) {
    png::Picture tip{8, 8, {}};
    for (unsigned y = 0; y < 8; ++y)
        for (unsigned x = 0; x < 8; ++x) tip.values.push_back(x < 4 && y >= 4 ? 1.0f : 0.0f);
    png::write(file("tip.png"), tip);
    Canvas canvas(device, square(), small());
    Stroke stroke = paint_model::one_dab();
    stroke.brush.picture = file("tip.png");
    stroke.brush.flow = 1;
    stroke.brush.cells = 20;
    canvas.paint(stroke);
    const State state = state_of(canvas);
    const Field field(state, 4);
    // A pixel is 2 * 1.5 * tan(0.4) / 200 wide, so that the brush's radius is 0.19 of the square's side. The brush's
    // picture is filled at the left and below: that quarter is painted.
    const double half = 30 * 3 * std::tan(0.4) / 200;
    unsigned inside = 0, corner = 0;
    for (const auto& [page, texels] : field.pages()) {
        if (page.level != 0) continue;
        for (Word i = 0; i < texels->size(); ++i) {
            const Field::Place at{i % 17, i / 17 % 17, i / 289};
            const Field::Colour c = field.texel(page, at);
            if (c[3] == 0) continue;
            const double x = (16 * page.at[0] + at[0]) / 128.0 - 0.5, y = (16 * page.at[1] + at[1]) / 128.0 - 0.5;
            const double soft = 1.2 * half / 8;  // half a pixel of the picture, which is filtered, and a margin
            EXPECT_TRUE(x > -half * 1.05 && x < soft && y > -half * 1.05 && y < soft) << x << ", " << y;
            inside += x < -soft && y < -soft && std::abs(c[0] - 1) < 0.01;
            corner += x < -0.9 * half && y < -0.9 * half;
        }
    }
    EXPECT_GT(inside, 500u);
    EXPECT_GT(corner, 5u) << "the brush is a square";
}

TEST_P(PaintBrush, SaysWhatIsWrongWithAPicture) {
    Canvas canvas(device, square(), small());
    Stroke stroke = paint_model::one_dab();
    stroke.brush.picture = file("missing.png");
    EXPECT_THROW(canvas.paint(stroke), std::runtime_error);
    png::write(file("dot.png"), {1, 1, {1}});
    stroke.brush.picture = file("dot.png");
    try {
        canvas.paint(stroke);
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("dot.png: the picture of a brush has to be 2 to 4096 pixels wide"));
    }
    glift::test::write_file(file("a.strokes"), R"({"brush": {"picture": "dot.png"}, "path": [[1, 2]]})");
    EXPECT_EQ(strokes::read(file("a.strokes"))[0].brush.picture, file("dot.png"));
    strokes::write(file("b.strokes"), strokes::read(file("a.strokes")));
    EXPECT_EQ(strokes::read(file("b.strokes"))[0].brush.picture, file("dot.png"));
    glift::test::write_file(file("c.strokes"), R"({"brush": {"picture": 3}, "path": [[1, 2]]})");
    EXPECT_THROW(strokes::read(file("c.strokes")), std::runtime_error);
}

/// A sphere in front of a sheet, painted along the sphere's outline with a colour without green. A picture from the
/// same camera shows no green under the stroke, neither where the outline hides a part of the surface around a node,
/// nor where the surface is seen edge-on.
TEST_P(PaintBrush, ColoursAllThatItSees) {
    Canvas canvas(device, model(), small());
    Stroke stroke = paint_model::one_dab();
    stroke.size = {300, 300};
    stroke.brush.radius = 60;
    stroke.brush.hardness = stroke.brush.flow = 1;
    stroke.path = {
        {float2(60, 60), 1}, {float2(240, 60), 1}, {float2(240, 240), 1}, {float2(60, 240), 1}, {float2(60, 60), 1}};
    canvas.paint(stroke);
    const picture::Picture seen = canvas.render(stroke.camera, stroke.size);
    const std::vector<paint::Brush> dabs = strokes::dabs_of(stroke);
    unsigned under = 0, green = 0;
    for (Word i = 0; i < 300 * 300; ++i) {
        const float2 pixel(static_cast<float>(i % 300), static_cast<float>(i / 300));
        const glift::float4 c = seen.pixels[i];
        const bool is_under = std::ranges::any_of(
            dabs, [&](const paint::Brush& dab) { return glift::length(pixel - dab.centre) < 0.75f * dab.radius; });
        if (!is_under || c.xyz() == sky) continue;
        ++under;
        green += c.y > 0.1f * c.x;
    }
    EXPECT_GT(under, 20000u);
    EXPECT_EQ(green, 0u);
}

/// A red stripe over a green coat, seen along its length at a flat angle: the part of the surface that a pixel shows is
/// long, but narrower than the stripe.
TEST_P(PaintBrush, HasNoColourFromBesideAtAFlatAngle) {
    Canvas canvas(device, square(), small());
    Stroke stroke = paint_model::one_dab();
    stroke.brush.hardness = stroke.brush.flow = 1;
    stroke.brush.radius = 80;
    stroke.brush.colour = {0, 1, 0};
    canvas.paint(stroke);
    stroke.brush.radius = 10;
    stroke.brush.colour = {1, 0, 0};
    stroke.path = {{float2(40, 100), 1}, {float2(160, 100), 1}};
    canvas.paint(stroke);
    const camera::Camera flat{{2.2f, 0.5f, 0.33f}, {0.5f, 0.5f, 0.25f}, {0, 0, 1}, 0.4f, 0.05f, 5};
    const glift::float4 middle = canvas.render(flat, {200, 200}).pixels[200 * 100 + 100];
    EXPECT_GT(middle.x, 0.1f);
    EXPECT_LT(middle.y, 0.01f * middle.x);
}

float decoded(double shown) {
    return static_cast<float>(shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4));
}

/// The texels of the page that is in this frame of the pool; null if no page is.
const Words* page_in(const State& state, Word frame) {
    for (std::size_t k = 0; k < state.pages.size(); ++k)
        if (state.table[state.pages[k]] - 1 == frame) return &state.texels[k];
    return nullptr;
}

/// The pool's 64 frames are shown in 8 rows of 8, each frame by its 17 x 17 columns of texels along z: 136 x 136
/// pixels.
TEST_P(PaintBrush, ShowsAllFramesAndTheTable) {
    Canvas canvas(device, model(), small(64));
    for (const Stroke& stroke : random_strokes(2, 21)) canvas.paint(stroke);
    const State state = state_of(canvas);
    painted::Layers layers{};
    layers.pool = layers.table = true;
    const picture::Picture seen = canvas.render(paint_model::one_dab().camera, {218, 218}, layers);
    const auto pixel = [&](Word x, Word y) { return seen.pixels[218 * y + x + 218 - 136]; };
    for (Word y = 0; y < 136; ++y)
        for (Word x = 0; x < 136; ++x) {
            const Words* page = page_in(state, x / 17 + y / 17 * 8);
            float wanted = 0;
            if (page) {
                wanted = 0.05f;
                for (Word z = 0; z < 17; ++z)
                    if (const Word c = (*page)[x % 17 + 17 * (16 - y % 17) + 289 * z]; c >> 24 != 0)
                        wanted = decoded((c & 255) / 255.0);
            }
            ASSERT_NEAR(pixel(x, y).x, wanted, 1e-3) << x << ", " << y;
        }
    // 136 pixels for 16 columns of pages: 8, 4, 2 and 1 of the four levels, and an empty one.
    const Field field(state, 4);
    for (Word level = 0, first = 0; level < 4; first += field.along(level++))
        for (Word y = 0; y < field.along(level); ++y)
            for (Word x = 0; x < field.along(level); ++x) {
                bool is_there = false;
                for (Word z = 0; z < field.along(level); ++z)
                    is_there = is_there || field.has({level, {x, field.along(level) - 1 - y, z}});
                const glift::float4 c = pixel((first + x) * 17 / 2 + 4, 218 - 68 + y * 17 / 2 + 4);
                EXPECT_EQ(std::max({c.x, c.y, c.z}) > 0.5f, is_there) << level << ": " << x << ", " << y;
            }
}

}  // namespace
