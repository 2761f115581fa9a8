// Octree 3-D paint: the same bits on every device and run, undone and done again, saved and loaded, beside sums of
// doubles; pools that are too small.
#include "examples/common/shapes.h"
#include "examples/paint/canvas.h"
#include "examples/paint/paint_file.h"
#include "support/process.h"

#include <glift/host/math.h>

#include <gmock/gmock.h>

#include <cstdlib>
#include <random>

namespace {

using glift::float2;
using glift::float3;
using glift::uint2;
using Words = std::vector<glift::uint>;
using strokes::Stroke;

glift::Device vulkan() {
    const char* name = std::getenv("GLIFT_TEST_DEVICE");
    return glift::Device::open(name ? name : "lavapipe");
}

/// A sphere before a sheet that it touches, within [0, 1]^3.
mesh::Mesh model() {
    mesh::Mesh made;
    mesh::add_sphere(made, {0.45f, 0.5f, 0.55f}, 0.35f, 24, {1, 1, 1});
    mesh::add_sheet(
        made, 7, 9, [](float u, float v) { return float3(u, 1 - v, 0.1f + 0.11f * u); },
        [](float, float) { return float3(1, 1, 1); });
    mesh::normalise(made);
    return made;
}

/// Random strokes from random sides; the first of them coarse, the next ones over and beside it.
std::vector<Stroke> random_strokes(unsigned count, unsigned seed) {
    std::mt19937 random(seed);
    const auto number = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
    std::vector<Stroke> made(count);
    for (Stroke& stroke : made) {
        const float3 to = glift::normalize(float3(number() - 0.5f, number() - 0.5f, 0.3f + number()));
        stroke.camera = {float3(0.5f, 0.5f, 0.4f) + to * 1.7f, {0.5f, 0.5f, 0.4f}, {0, 1, 0}, 0.6f, 0.05f, 5};
        stroke.size = {160, 120};
        stroke.brush = {&stroke == made.data() ? 30.0f : 3 + 12 * number(), number(), number() < 0.3f ? 0.8f : 0.0f, 1,
                        0.2f + 0.8f * number(), 6 + 10 * number(), {number(), number(), number()},
                        static_cast<glift::uint>(random() % 8 == 0 ? 2 : random() % 4 == 0)};
        for (unsigned i = 0; i < 3; ++i)
            stroke.path.push_back({float2(40 + 80 * number(), 30 + 60 * number()), 0.3f + 0.7f * number()});
    }
    return made;
}

OctreeSize small(glift::uint pages = 1500) {
    OctreeSize size;
    size.resolution = 128;
    size.pages = pages;
    return size;
}

struct State {
    Words table, pages;
    std::vector<Words> texels;
    bool operator==(const State&) const = default;
};

State state_of(Canvas& canvas) {
    State state;
    journal::Octree& octree = canvas.octree();
    state.table = octree.best().read();
    state.pages = octree.pages().active().read(0, octree.status(canvas.device()).resident);
    journal::PageList list(canvas.device(), static_cast<glift::uint>(state.pages.size()));
    list.write(state.pages);
    journal::Texels texels(canvas.device(), {4913, static_cast<glift::uint>(state.pages.size())});
    journal::store(canvas.device(), octree, list, texels);
    const Words all = texels.read();
    for (std::size_t i = 0; i < state.pages.size(); ++i)
        state.texels.emplace_back(all.begin() + static_cast<std::ptrdiff_t>(4913 * i),
                                  all.begin() + static_cast<std::ptrdiff_t>(4913 * (i + 1)));
    return state;
}

/// How many components of texels differ.
std::size_t differences(const State& a, const State& b) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < a.texels.size(); ++i)
        for (std::size_t k = 0; k < a.texels[i].size(); ++k)
            for (unsigned shift = 0; shift < 32; shift += 8)
                n += (a.texels[i][k] >> shift & 255) != (b.texels[i][k] >> shift & 255);
    return n;
}

TEST(Paint, IsTheSameOnEveryDeviceAndRun) {
    const std::vector<Stroke> all = random_strokes(6, 1);
    std::vector<State> states;
    for (const glift::Device& device : {glift::Device::open("host"), vulkan(), vulkan()}) {
        Canvas canvas(device, model(), small());
        for (const Stroke& stroke : all) EXPECT_EQ(canvas.paint(stroke), 0u);
        states.push_back(state_of(canvas));
    }
    EXPECT_GT(states[0].pages.size(), 100u);
    for (std::size_t i = 1; i < states.size(); ++i) {
        EXPECT_EQ(states[i].table, states[0].table);
        ASSERT_EQ(states[i].pages, states[0].pages);
        EXPECT_EQ(differences(states[i], states[0]), 0u);
    }
}

}  // namespace
