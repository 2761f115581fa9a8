// Paint on thin parts: a plate that is painted on its front has no paint on its back if it is thick enough, which is
// 2.25 cells where its normal lies along an axis, and more for other normals (least_thickness).
#include "paint_model.h"
#include "tests/device/guards/on_every_device.h"

#include <glift/host/math.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using namespace paint_model;
using glift::float2;
using glift::float3;

constexpr float cell = 1.0f / 128;
constexpr Word levels = 4;  // of 128^3 cells

struct PaintThin : OnEveryDevice {};
GLIFT_ON_EVERY_DEVICE(PaintThin);

/// A square plate: the centre of its front, and unit vectors along its sides and from its back to its front.
struct Plate {
    float3 centre, right, up, front;
    float thickness;

    /// A point of the front or of the back; x and y are from -1 to 1 between the edges.
    float3 at(float x, float y, bool in_front) const {
        return centre + right * (0.3f * x) + up * (0.3f * y) + front * (in_front ? 0.0f : -thickness);
    }
    mesh::Mesh mesh() const {
        mesh::Mesh made;
        for (const bool in_front : {true, false})
            for (const float2& corner : {float2(-1, -1), float2(1, -1), float2(1, 1), float2(-1, 1)})
                made.points.push_back(at(corner.x, corner.y, in_front));
        made.corners = {0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6};
        return made;
    }
};

/// The least thickness of a plate for which no lookup on its back reads a node that is painted from the front. Lookups
/// read nodes up to `read` cells away, measured along the normal: 1 for an axis, the square root of 3 for a diagonal.
/// Nodes are painted up to a quarter of a cell farther away than `read`, but at most 1.75 cells.
float least_thickness(const float3& normal) {
    const float read = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
    return cell * (read + std::min(read + 0.25f, 1.75f));
}

Plate random_plate(std::mt19937& random, const float3& front) {
    const auto number = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
    const float3 right = glift::normalize(glift::cross(float3(0.36f, 0.48f, 0.8f), front));
    const float3 centre(0.5f + cell * number(), 0.5f + cell * number(), 0.5f + cell * number());
    return {centre, right, glift::cross(front, right), front, 1.001f * least_thickness(front)};
}

std::vector<Plate> plates() {
    std::mt19937 random(31);
    std::vector<Plate> made;
    for (const float3& front : {float3(0, 0, 1), float3(-1, 0, 0), float3(1, 1, 0), float3(1, 1, 1), float3(-3, 5, 2),
                                float3(1, -6, -1), float3(4, 4, -1)})
        made.push_back(random_plate(random, glift::normalize(front)));
    return made;
}

/// One hard dab on the plate's middle. The camera sees the plate from the front; the larger `beside`, the more
/// obliquely.
strokes::Stroke dab_on(const Plate& plate, float beside) {
    strokes::Stroke stroke = one_dab();
    stroke.camera.eye = plate.centre + glift::normalize(plate.front + plate.right * beside) * 1.5f;
    stroke.camera.target = plate.centre;
    stroke.camera.up = plate.up;
    stroke.brush.hardness = stroke.brush.flow = 1;
    stroke.brush.cells = 20;  // so many that the dab paints on level 0, the finest
    stroke.brush.colour = {1, 0, 1};
    return stroke;
}

struct Painted {
    double least = 2, most = -1;  ///< of the green that is left, 0 to 1
};

/// The green that is left on one side, over the middle of what the brush covers.
Painted green_of(const Plate& plate, const Field& field, bool in_front) {
    constexpr int steps = 40;
    Painted found;
    for (int y = -steps; y <= steps; ++y)
        for (int x = -steps; x <= steps; ++x) {
            const float3 at =
                plate.at(0.4f * static_cast<float>(x) / steps, 0.4f * static_cast<float>(y) / steps, in_front) / cell;
            const double green = field.sample({at.x, at.y, at.z}, 0.0)[1];
            found.least = std::min(found.least, green), found.most = std::max(found.most, green);
        }
    return found;
}

TEST_P(PaintThin, IsOnTheSideThatTheBrushSeesAlone) {
    for (const Plate& plate : plates())
        for (const float beside : {0.0f, 0.5f}) {
            OctreeSize size = small();
            size.ground = {0, 1, 0};
            Canvas canvas(device, plate.mesh(), size);
            ASSERT_EQ(canvas.paint(dab_on(plate, beside)), 0u);
            const State state = state_of(canvas);
            const Field field(state, levels);
            const Painted front = green_of(plate, field, true), back = green_of(plate, field, false);
            EXPECT_EQ(front.most, 0) << plate.front.x << " " << plate.front.y << " " << plate.front.z << ", " << beside;
            EXPECT_EQ(back.least, 1) << plate.front.x << " " << plate.front.y << " " << plate.front.z << ", " << beside;
        }
}

}  // namespace
