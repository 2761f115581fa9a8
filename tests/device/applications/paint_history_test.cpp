// The history of strokes: many are undone and done again, which gives back every bit, and one that changes nothing
// counts, too.
#include "paint_model.h"
#include "support/process.h"
#include "tests/device/guards/on_every_device.h"

#include <gmock/gmock.h>

namespace {

using namespace paint_model;
using strokes::Stroke;

struct PaintHistory : OnEveryDevice {};
GLIFT_ON_EVERY_DEVICE(PaintHistory);

OctreeSize tiny() {
    OctreeSize size;
    size.resolution = 64;
    size.pages = 80;
    return size;
}

std::vector<Stroke> small_strokes(unsigned count, unsigned seed) {
    std::vector<Stroke> all = random_strokes(count, seed);
    for (Stroke& stroke : all) {
        stroke.size = {48, 36};
        stroke.brush.radius = 2 + 0.2f * stroke.brush.radius;
        stroke.brush.cells = 3;
        for (strokes::Touch& touch : stroke.path) touch.place = touch.place * 0.3f;
        stroke.path.resize(1);
    }
    return all;
}

/// The stroke, seen by a camera that looks the other way, where there is no model: it paints nothing.
Stroke missing(Stroke stroke) {
    stroke.camera.target = stroke.camera.eye * 2.0f - stroke.camera.target;
    return stroke;
}

/// Runs on the host device alone, since Vulkan takes minutes. Compares every bit after each tenth step only; paint_test
/// does so after each step, with fewer strokes, on every device.
TEST(LongPaintHistory, GivesBackEveryBitOfFiftyStrokes) {
    const glift::Device device = glift::Device::open("host");
    OctreeSize size = tiny();
    size.history.device = 2 << 20;  // bytes: too few for all strokes, so that some are kept on the host
    Canvas canvas(device, model(), size);
    std::vector<State> states{state_of(canvas)};
    const std::vector<Stroke> all = small_strokes(50, 30);
    for (std::size_t i = 0; i < all.size(); ++i) {
        canvas.paint(all[i]);
        if ((i + 1) % 10 == 0) states.push_back(state_of(canvas));
    }
    ASSERT_EQ(canvas.history().undoable(), 50u);
    EXPECT_GT(canvas.history().host_bytes(), 0u);
    for (std::size_t tens = 5; tens-- > 0;) {
        for (unsigned i = 0; i < 10; ++i) ASSERT_TRUE(canvas.undo());
        EXPECT_TRUE(state_of(canvas) == states[tens]) << "undone to " << 10 * tens;
    }
    EXPECT_FALSE(canvas.undo());
    for (std::size_t tens = 1; tens <= 5; ++tens) {
        for (unsigned i = 0; i < 10; ++i) ASSERT_TRUE(canvas.redo());
        EXPECT_TRUE(state_of(canvas) == states[tens]) << "done again to " << 10 * tens;
    }
    EXPECT_FALSE(canvas.redo());
}

TEST_P(PaintHistory, CountsAStrokeThatChangesNothing) {
    Canvas canvas(device, model(), tiny());
    const std::vector<Stroke> all = small_strokes(2, 31);
    canvas.paint(all[0]);
    const State hit = state_of(canvas);
    canvas.paint(missing(all[1]));
    EXPECT_TRUE(state_of(canvas) == hit);
    EXPECT_EQ(canvas.history().undoable(), 2u);
    ASSERT_TRUE(canvas.undo());
    EXPECT_TRUE(state_of(canvas) == hit) << "the last stroke is the one that missed";
    ASSERT_TRUE(canvas.redo());
    EXPECT_TRUE(state_of(canvas) == hit);
    // A stroke that changes nothing also takes the place of those that were undone, as every stroke does.
    canvas.undo();
    canvas.undo();
    canvas.paint(missing(all[1]));
    EXPECT_EQ(canvas.history().redoable(), 0u);
    EXPECT_FALSE(canvas.redo());
    EXPECT_EQ(canvas.history().undoable(), 1u);
}

}  // namespace
