// Octree 3-D paint: strokes give the same bits on every device and in every run, and after undo and redo; samples are
// near those in double precision; pages meet without a step, and coarse levels have the means of finer ones; painting
// stops where the pool is full.
#include "paint_model.h"
#include "tests/device/guards/on_every_device.h"

#include "paint_samples.glift.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>
#include <set>

namespace {

using namespace paint_model;
using glift::float4;
using strokes::Stroke;

constexpr Word levels = 4;  // of 128^3 cells: 8, 4, 2 and 1 pages of 16 cells along each axis

/// The number of strokes: GLIFT_PAINT_STROKES, or 4.
unsigned stroke_count() {
    const char* text = std::getenv("GLIFT_PAINT_STROKES");
    return text ? static_cast<unsigned>(std::stoul(text)) : 4;
}

struct Paint : OnEveryDevice {};
GLIFT_ON_EVERY_DEVICE(Paint);

TEST(PaintOfStrokes, IsTheSameOnEveryDeviceAndRun) {
    const std::vector<Stroke> all = random_strokes(stroke_count(), 1);
    const char* name = std::getenv("GLIFT_TEST_DEVICE");
    const std::string vulkan = name ? name : "lavapipe";
    std::vector<State> states;
    for (const std::string& device : {std::string("host"), vulkan, vulkan}) {
        Canvas canvas(glift::Device::open(device), model(), small());
        for (const Stroke& stroke : all) EXPECT_EQ(canvas.paint(stroke), 0u);
        states.push_back(state_of(canvas));
    }
    EXPECT_GT(states[0].pages.size(), 100u);
    for (std::size_t i = 1; i < states.size(); ++i) {
        EXPECT_EQ(states[i].table, states[0].table);
        EXPECT_EQ(states[i].pages, states[0].pages);
        EXPECT_TRUE(states[i].texels == states[0].texels);
    }
}

TEST_P(Paint, IsUndoneAndDoneAgainBitByBit) {
    OctreeSize size = small();
    size.history.device = 3 << 20;  // bytes: too few for all strokes, so that some are kept on the host
    Canvas canvas(device, model(), size);
    std::vector<State> states{state_of(canvas)};
    for (const Stroke& stroke : random_strokes(stroke_count(), 2)) {
        canvas.paint(stroke);
        states.push_back(state_of(canvas));
    }
    EXPECT_GT(canvas.history().host_bytes(), 0u);
    EXPECT_LE(canvas.history().device_bytes(), size.history.device);
    const auto matches = [&](std::size_t i) { return state_of(canvas) == states[i]; };
    for (std::size_t i = states.size() - 1; i-- > 0;) {
        ASSERT_TRUE(canvas.undo());
        EXPECT_TRUE(matches(i)) << "undone to " << i;
    }
    EXPECT_FALSE(canvas.undo());
    for (std::size_t i = 1; i < states.size(); ++i) {
        ASSERT_TRUE(canvas.redo());
        EXPECT_TRUE(matches(i)) << "done again to " << i;
    }
    EXPECT_FALSE(canvas.redo());
    // Another stroke instead of those that were undone.
    canvas.undo();
    canvas.paint(random_strokes(2, 3)[1]);
    EXPECT_EQ(canvas.history().redoable(), 0u);
    canvas.undo();
    EXPECT_TRUE(matches(states.size() - 2));
}

TEST_P(Paint, ForgetsTheOldestStrokesBeyondItsBudget) {
    OctreeSize size = small();
    size.history = {0, 4 << 20};
    Canvas canvas(device, model(), size);
    for (const Stroke& stroke : random_strokes(4, 4)) canvas.paint(stroke);
    const State last = state_of(canvas);
    EXPECT_LE(canvas.history().host_bytes(), size.history.host);
    EXPECT_LT(canvas.history().undoable(), 4u);
    const std::size_t n = canvas.history().undoable();
    for (std::size_t i = 0; i < n; ++i) EXPECT_TRUE(canvas.undo());
    for (std::size_t i = 0; i < n; ++i) EXPECT_TRUE(canvas.redo());
    EXPECT_TRUE(state_of(canvas) == last);
}

/// Random points, and a level in the last component. Some coordinates are those of nodes, some those of faces of pages.
std::vector<float4> places_of(unsigned count, unsigned seed) {
    std::mt19937 random(seed);
    const auto number = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
    std::vector<float4> made;
    for (unsigned i = 0; i < count; ++i) {
        float4 x(0, 0, 0, i % 3 == 0 ? 0.0f : (levels - 1) * number());
        for (unsigned axis = 0; axis < 3; ++axis) {
            const bool on_edge = random() % 4 == 0, on_node = random() % 4 == 0;
            x[axis] = 0.5f + 128 * number();
            if (on_edge) x[axis] = 0.5f + 16 * std::floor(9 * number());
            else if (on_node) x[axis] = std::floor(x[axis]) + 0.5f;
        }
        made.push_back(x);
    }
    return made;
}

TEST_P(Paint, IsFilteredAsDoublesAre) {
    Canvas canvas(device, model(), small());
    for (const Stroke& stroke : random_strokes(3, 5)) canvas.paint(stroke);
    const State state = state_of(canvas);
    const Field field(state, levels);
    const std::vector<float4> places = places_of(4000, 6);
    paint_samples::Places at(device, static_cast<Word>(places.size()));
    const paint_samples::Samples samples(device, static_cast<Word>(places.size()));
    at.write(places);
    paint_samples::sample(device, at, canvas.octree(), samples);
    const std::vector<float4> found = samples.read();
    // Samplers, lavapipe's included, filter texels of eight bits with weights of eight bits along each axis.
    const double bound = device.properties().kind == glift::DeviceKind::host ? 1e-4 : 3.0 / 256;
    double worst = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::array<double, 3> x{places[i].x - 0.5, places[i].y - 0.5, places[i].z - 0.5};
        const Field::Colour wanted = field.sample(x, static_cast<double>(places[i].w));
        for (unsigned k = 0; k < 4; ++k)
            worst = std::max(worst, std::abs(wanted[k] - static_cast<double>(found[i][k])));
    }
    EXPECT_LT(worst, bound);
}

/// On the host device alone, since the octree is the same on every device.
TEST(PaintOfStrokes, HasNoStepWherePagesMeet) {
    const glift::Device device = glift::Device::open("host");
    Canvas canvas(device, model(), small());
    for (const Stroke& stroke : random_strokes(4, 7)) canvas.paint(stroke);
    const State state = state_of(canvas);
    const Field field(state, levels);
    std::mt19937 random(8);
    const auto number = [&] { return 128.0 * static_cast<double>(random() >> 8) * 0x1p-24; };
    double worst = 0;
    for (unsigned i = 0; i < 4000; ++i) {
        std::array<double, 3> low{number(), number(), number()};
        low[i % 3] = 16.0 * (1 + random() % 7) - 1e-6;
        std::array<double, 3> high = low;
        high[i % 3] += 2e-6;
        const Field::Colour a = field.sample(low, 0.0), b = field.sample(high, 0.0);
        for (unsigned k = 0; k < 4; ++k) worst = std::max(worst, std::abs(a[k] - b[k]));
    }
    EXPECT_LT(worst, 1.0 / 255) << "hanging nodes are rounded to eight bits, half a step at most on each side";
}

TEST(PaintOfStrokes, HasTheMeansOfFinerLevels) {
    const glift::Device device = glift::Device::open("host");
    Canvas canvas(device, model(), small());
    for (const Stroke& stroke : random_strokes(4, 9)) canvas.paint(stroke);
    const State state = state_of(canvas);
    const Field field(state, levels);
    std::size_t means = 0;
    double worst = 0;
    for (const auto& [page, texels] : field.pages())
        for (Word i = 0; i < texels->size(); i += 3) {
            const Field::Place inside{i % 17, i / 17 % 17, i / 289};
            Field::Place node{};
            for (unsigned axis = 0; axis < 3; ++axis) node[axis] = 16 * page.at[axis] + inside[axis];
            if (field.hangs(node, page.level)) continue;
            const auto mean = field.mean(node, page.level);
            if (!mean) continue;
            ++means;
            const Field::Colour found = field.texel(page, inside);
            for (unsigned k = 0; k < 4; ++k) worst = std::max(worst, std::abs(found[k] - (*mean)[k]));
        }
    EXPECT_GT(means, 1000u);
    EXPECT_LT(worst, 0.501 / 255) << "rounded to eight bits";
}

TEST_P(Paint, StopsWhereThePoolIsFull) {
    Canvas canvas(device, model(), small(40));
    Word lost = 0;
    std::vector<State> states{state_of(canvas)};
    for (const Stroke& stroke : random_strokes(3, 10)) {
        lost += canvas.paint(stroke);
        states.push_back(state_of(canvas));
    }
    EXPECT_GT(lost, 0u);
    EXPECT_EQ(canvas.pages(), 40u);
    std::set<Word> frames;
    for (const Word entry : states.back().table) {
        if (entry == 0 || entry >> 27 != 0) continue;
        EXPECT_TRUE(frames.insert(entry).second) << "a frame of two pages";
    }
    EXPECT_EQ(frames.size(), 40u);
    for (std::size_t i = states.size() - 1; i-- > 0;) {
        ASSERT_TRUE(canvas.undo());
        EXPECT_TRUE(state_of(canvas) == states[i]);
    }
}

/// A dab, and the end of a stroke, are one submission each, also where pages come and go.
TEST(PaintOnVulkan, SubmitsOnceADab) {
    const char* name = std::getenv("GLIFT_TEST_DEVICE");
    const glift::Device device = glift::Device::open(name ? name : "lavapipe");
    Canvas canvas(device, model(), small());  // for its model
    const Model& m = canvas.model();
    const Stroke stroke = random_strokes(1, 20)[0];
    journal::Octree octree(device, levels, 1500);
    journal::Journal journal(device, levels, 1500);
    const surface::Surface surface(device, stroke.size);
    const surface::Normals normals(device, stroke.size);
    const surface::Viewpoint view = strokes::viewpoint_of(stroke.camera, stroke.size);
    paint::Tip tip(device, {1, 1});
    tip.write(std::vector<float>{1});
    paint::clear(device, octree, canvas.ground());
    surface::look(device, m.corners(), m.rest(), m.rest(), view, surface, normals);
    journal.clear(device);
    const auto submissions = [&](const auto& work) {
        device.wait();
        const std::uint64_t before = device.statistics().submissions;
        work();
        device.wait();
        return device.statistics().submissions - before;
    };
    EXPECT_EQ(submissions([] {}), 0u);
    for (const paint::Brush& dab : strokes::dabs_of(stroke))
        EXPECT_EQ(submissions([&] {
                      paint::paint(device, octree, journal, surface, normals, view, dab, tip, canvas.ground());
                  }),
                  1u);
    EXPECT_GT(octree.status(device).resident, 20u);
    EXPECT_EQ(submissions([&] { paint::finish(device, octree, journal); }), 1u);
}

/// Compares a bent model with its formula in long double, for small and large angles: from near 0, where the model must
/// hardly move, up to nearly a full turn.
TEST(PaintedModel, IsBentAsDoublesSay) {
    const mesh::Mesh mesh = model();
    const mesh::Box box = mesh::bounds_of(mesh);
    const glift::float3 middle = (box.low + box.high) * 0.5f;
    for (const float angle : {1e-30f, 1e-6f, -1e-3f, 0.7f, -6.0f}) {
        const std::vector<glift::float3> points = bent(mesh, angle);
        const long double by = static_cast<long double>(angle);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const long double x = mesh.points[i].x - middle.x, z = mesh.points[i].z - middle.z;
            // The series is exact enough for small angles, and not used for others.
            const bool is_small = std::abs(angle) < 1e-2f;
            const long double across = is_small ? x - by * by * x * x * x / 6 : std::sin(x * by) / by;
            const long double back = is_small ? by * x * x / 2 : (1 - std::cos(x * by)) / by;
            EXPECT_NEAR(points[i].x, static_cast<double>(middle.x + across + std::sin(x * by) * z), 1.5e-7);
            EXPECT_NEAR(points[i].z, static_cast<double>(middle.z - back + std::cos(x * by) * z), 1.5e-7);
            EXPECT_EQ(points[i].y, mesh.points[i].y);
        }
    }
}

/// The same kernel reads an octree and a 3-D image of its nodes, and finds the same colours.
TEST_P(Paint, IsReadAsA3DImageIs) {
    OctreeSize size = small();
    size.resolution = 64;
    Canvas canvas(device, model(), size);
    for (const Stroke& stroke : random_strokes(2, 23)) canvas.paint(stroke);
    paint_samples::Volume volume(device, {65, 65, 65});
    paint_samples::fill_volume(device, canvas.octree(), volume);
    std::mt19937 random(24);
    std::vector<float4> at(20'000);
    for (float4& p : at)
        for (unsigned i = 0; i < 3; ++i) p[i] = 0.5f + 64 * static_cast<float>(random() >> 8) * 0x1p-24f;
    const auto n = static_cast<Word>(at.size());
    paint_samples::Places places(device, n);
    places.write(at);
    paint_samples::Samples by_octree(device, n), by_volume(device, n);
    paint_samples::read_octree(device, places, canvas.octree(), by_octree);
    paint_samples::read_volume(device, places, volume, by_volume);
    const std::vector<float4> a = by_octree.read(), b = by_volume.read();
    // A filter's weights are multiples of 1/256 on each of three axes; the image's texels are rounded to 1/255.
    constexpr double bound = 3.0 / 256 + 0.5 / 255;
    unsigned painted = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        for (unsigned i = 0; i < 3; ++i) ASSERT_NEAR(a[k][i], b[k][i], bound) << k;
        painted += a[k].w > 0;
    }
    EXPECT_GT(painted, 300u);
}

}  // namespace
