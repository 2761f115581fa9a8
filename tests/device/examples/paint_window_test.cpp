// Painting in a window: a stroke is seen, undone, done again, and the strokes that were recorded make the same picture
// without a window.
#include "windows.h"

#include <filesystem>

namespace {

using testing::HasSubstr;
using windows::waited_for;

struct PaintWindows : windows::Windows {
    PaintWindows() : Windows(GLIFT_PAINT, "Paint", "the same picture: paint ") {
        glift::test::write_file(file("sheet.obj"), "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.2\nf 1 2 3 4\n");
    }
    std::vector<std::string> arguments() const {
        return {file("sheet.obj"),
                "--resolution",
                "128",
                "--pages",
                "300",
                "--size",
                "320",
                "240",
                "--turn",
                "0",
                "--upwards",
                "0",
                "--out",
                file("seen.png"),
                "--record",
                file("made.strokes")};
    }
    void drag(unsigned button, int from_x, int from_y, int to_x, int to_y) const {
        constexpr int steps = 6;
        const auto wait = [] { std::this_thread::sleep_for(std::chrono::milliseconds(60)); };
        display.move_to(from_x, from_y);
        wait();
        display.press(button);
        wait();
        for (int i = 1; i <= steps; ++i) {
            display.move_to(from_x + (to_x - from_x) * i / steps, from_y + (to_y - from_y) * i / steps);
            wait();
        }
        display.release(button);
    }
};

TEST_F(PaintWindows, PaintUndoAndTurn) {
    std::vector<std::string> words = arguments();
    words.resize(words.size() - 4);  // without --out and --record
    const picture::Picture blank = headless(words);
    const auto running = started(arguments());
    settled({});
    EXPECT_TRUE(waited_for([&] { return windows::farthest(display.seen(), blank) > 20; })) << "the panel covers a part";
    keep(display.seen(), "paint_window_panel.png");
    display.type("Tab");
    ASSERT_TRUE(shows(blank)) << running->err();
    drag(1, 130, 100, 200, 150);
    EXPECT_TRUE(waited_for([&] { return windows::farthest(display.seen(), blank) > 20; })) << running->err();
    display.type("z");
    display.type("y");
    display.type("z");
    EXPECT_TRUE(shows(blank)) << running->err();
    drag(3, 200, 100, 160, 110);
    display.type("y");
    display.type("s");
    ASSERT_TRUE(waited_for([&] { return std::filesystem::exists(file("seen.png")); })) << running->err();
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    const picture::Picture painted = picture::read(file("seen.png"));
    EXPECT_TRUE(shows(painted)) << running->err();
    EXPECT_GT(windows::farthest(display.seen(), blank), 20);
    display.type("b");
    EXPECT_TRUE(waited_for([&] { return windows::farthest(display.seen(), painted) > 20; })) << "borders of pages";
    keep(display.seen(), "paint_window_borders.png");
    display.type("Escape");
    EXPECT_EQ(running->exit_code(), 0) << running->err();
    const picture::Picture same = said(*running);
    EXPECT_EQ(same.pixels, painted.pixels) << running->out();
    EXPECT_THAT(running->out(), testing::Not(HasSubstr("--turn 0 ")));
    EXPECT_FALSE(glift::test::read_file(file("made.strokes")).empty());
}

}  // namespace
