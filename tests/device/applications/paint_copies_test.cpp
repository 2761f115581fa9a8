// Pages beside each other share a layer of nodes: after dabs of hard brushes, seen at low angles, all copies of a node
// have the same colour but for the rounding to 8 bits of values that pages began with.
#include "paint_model.h"
#include "tests/device/guards/on_every_device.h"

#include "examples/common/shapes.h"

#include <cmath>
#include <random>

namespace {

using namespace paint_model;
using glift::float2;
using glift::float3;

constexpr Word levels = 4, cells = 16;  // of 128^3 cells

struct PaintCopies : OnEveryDevice {};
GLIFT_ON_EVERY_DEVICE(PaintCopies);

mesh::Mesh sheet() {
    mesh::Mesh made;
    mesh::add_sheet(
        made, 1, 1, [](float u, float v) { return float3(u, v, 0.253f); },
        [](float, float) { return float3(1, 1, 1); });
    return made;
}

/// Single dabs on the sheet, seen from 4 to 11 degrees above it.
std::vector<strokes::Stroke> strokes_at_low_angles(unsigned count) {
    std::mt19937 random(9);
    const auto number = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
    std::vector<strokes::Stroke> made(count);
    for (strokes::Stroke& stroke : made) {
        const float3 centre(0.5f, 0.5f, 0.253f);
        const float around = 6.28f * number();
        const float3 away(std::cos(around), std::sin(around), 0.07f + 0.12f * number());
        stroke.camera = {centre + away * 1.5f, centre, {0, 0, 1}, 0.8f, 0.05f, 5};
        stroke.size = {400, 400};
        stroke.brush.radius = 20;
        stroke.brush.hardness = 1;
        stroke.brush.flow = 1;
        stroke.brush.cells = 8;
        for (unsigned i = 0; i < 3; ++i) stroke.brush.colour[i] = number();
        stroke.path = {{float2(140 + 120 * number(), 190 + 20 * number()), 1}};
    }
    return made;
}

TEST_P(PaintCopies, OfANodeAreEqual) {
    Canvas canvas(device, sheet(), small());
    for (const strokes::Stroke& stroke : strokes_at_low_angles(12)) ASSERT_EQ(canvas.paint(stroke), 0u);
    const State state = state_of(canvas);
    const Field field(state, levels);
    unsigned shared = 0;
    for (const auto& entry : field.pages()) {
        const Field::Page& page = entry.first;
        for (Word k = 0; k < 17 * 17 * 17; ++k) {
            const Field::Place inside{k % 17, k / 17 % 17, k / 289};
            const Field::Place node{page.at[0] * cells + inside[0], page.at[1] * cells + inside[1],
                                    page.at[2] * cells + inside[2]};
            if (inside[0] % cells != 0 && inside[1] % cells != 0 && inside[2] % cells != 0) continue;
            for (const Field::Page& other : field.around(node, page.level)) {
                if (other == page || !field.has(other)) continue;
                Field::Place there{};
                for (unsigned axis = 0; axis < 3; ++axis) there[axis] = node[axis] - other.at[axis] * cells;
                const Field::Colour one = field.texel(page, inside), same = field.texel(other, there);
                for (unsigned i = 0; i < 3; ++i)
                    ASSERT_LE(std::abs(one[i] - same[i]), 1.001 / 255)
                        << "node " << node[0] << " " << node[1] << " " << node[2] << " of level " << page.level;
                ++shared;
            }
        }
    }
    EXPECT_GT(shared, 10000u);
}

}  // namespace
