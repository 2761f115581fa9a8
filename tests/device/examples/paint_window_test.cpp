// Painting in a window: a stroke is seen, undone, done again, and the strokes that were recorded make the same picture
// without a window. No stroke is lost when a file cannot be saved or the display goes away.
#include "windows.h"

#include <algorithm>
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
    void click(int x, int y) const { drag(1, x, y, x, y); }
    /// A window without its panel, which shows the blank model.
    std::unique_ptr<windows::Running> blank_window(const std::vector<std::string>& words) {
        auto running = started(words);
        settled({});
        display.type("Tab");
        blank_ = settled({});
        return running;
    }
    /// Paints on the model, and waits until that is seen.
    void paint() {
        drag(1, 130, 100, 200, 150);
        EXPECT_NE(settled(blank_).pixels, blank_.pixels);
    }
    std::size_t recorded() const {
        const std::string lines = glift::test::read_file(file("made.strokes"));
        return static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n'));
    }

    Seen blank_;
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

/// A stroke that misses the model counts as a stroke, too: it replaces the one that was undone, in the record as well.
TEST_F(PaintWindows, RecordTheStrokesThatWereNotUndone) {
    const auto running = blank_window(arguments());
    paint();
    display.type("z");
    ASSERT_TRUE(waited_for([&] { return display.seen().pixels == blank_.pixels; })) << running->err();
    click(300, 120);
    display.type("y");
    display.type("y");
    display.type("Escape");
    EXPECT_EQ(running->exit_code(), 0) << running->err();
    EXPECT_EQ(recorded(), 1u);
    EXPECT_LE(windows::farthest(blank_, said(*running)), windows::rounding) << running->out();
}

/// The key S, when the picture's folder no longer exists: the panel says so, and painting goes on.
TEST_F(PaintWindows, GoOnWhereSavingFails) {
    std::filesystem::create_directory(file("it's"));
    std::vector<std::string> words = arguments();
    words[13] = file("it's/seen.png");
    const auto running = blank_window(words);
    paint();
    std::filesystem::remove(file("it's"));
    const Seen painted = display.seen();
    display.type("s");
    EXPECT_TRUE(waited_for([&] { return running->err().find("seen.png: cannot be written") != std::string::npos; }));
    const Seen panel = settled(painted);
    keep(panel, "paint_window_not_saved.png");
    display.type("Tab");  // hides the panel, which covers the model
    EXPECT_NE(settled(panel).pixels, panel.pixels);
    std::filesystem::create_directory(file("it's"));
    drag(1, 230, 180, 150, 190);
    display.type("s");
    EXPECT_TRUE(waited_for([&] { return std::filesystem::exists(file("it's/seen.png")); }));
    display.type("Escape");
    EXPECT_EQ(running->exit_code(), 0) << running->err();
    EXPECT_EQ(recorded(), 2u);
    EXPECT_THAT(running->out(), HasSubstr("--out '" + folder.path().string() + "/it'\\''s/seen.png'"));
}

/// The last save fails: the strokes are recorded nevertheless.
TEST_F(PaintWindows, RecordStrokesWhereSavingFails) {
    std::filesystem::create_directory(file("gone"));
    std::vector<std::string> words = arguments();
    words.insert(words.end(), {"--save", file("gone/a.paint")});
    const auto running = blank_window(words);
    paint();
    std::filesystem::remove(file("gone"));
    display.type("Escape");
    EXPECT_EQ(running->exit_code(), 1);
    EXPECT_THAT(running->err(), HasSubstr("gone/a.paint: cannot be written"));
    EXPECT_THAT(running->out(), testing::Not(HasSubstr("the same picture")));
    EXPECT_EQ(recorded(), 1u);
}

/// The display goes away in the middle of the second stroke.
TEST_F(PaintWindows, RecordStrokesWhereTheDisplayIsLost) {
    std::vector<std::string> words = arguments();
    words.insert(words.end(), {"--save", file("a.paint")});
    const auto running = blank_window(words);
    paint();
    display.move_to(150, 180);
    display.press();
    display.move_to(200, 190);
    settled(display.seen());
    display.end();
    EXPECT_EQ(running->exit_code(), 1) << running->err();
    EXPECT_THAT(running->err(), HasSubstr("gone"));
    EXPECT_EQ(recorded(), 2u);
    EXPECT_TRUE(std::filesystem::exists(file("a.paint"))) << "the paint is saved, too";
}

/// The paint is saved over the file that it was loaded from. That file then contains the strokes of the session, so the
/// command that the program prints for the same picture must not paint them again.
TEST_F(PaintWindows, SayHowToSeePaintThatWasSavedOverTheOldOne) {
    std::vector<std::string> words = arguments();
    words.insert(words.end(), {"--save", file("a.paint")});
    {
        const auto running = blank_window(words);
        paint();
        display.type("Escape");
        ASSERT_EQ(running->exit_code(), 0) << running->err();
    }
    words.insert(words.end(), {"--load", file("a.paint")});
    const auto running = blank_window(words);
    drag(1, 230, 180, 150, 190);
    EXPECT_NE(settled(blank_).pixels, blank_.pixels);
    display.type("s");
    ASSERT_TRUE(waited_for([&] { return std::filesystem::exists(file("seen.png")); })) << running->err();
    display.type("Escape");
    ASSERT_EQ(running->exit_code(), 0) << running->err();
    EXPECT_THAT(running->out(), testing::Not(HasSubstr("--strokes")));
    EXPECT_EQ(said(*running).pixels, picture::read(file("seen.png")).pixels) << running->out();
}

TEST_F(PaintWindows, RefuseABrushBeforeAStroke) {
    glift::test::write_file(file("no.png"), "no picture");
    std::vector<std::string> words = arguments();
    words.insert(words.end(), {"--brush", file("no.png")});
    const auto running = started(words);
    EXPECT_EQ(running->exit_code(), 1);
    EXPECT_THAT(running->err(), HasSubstr("no.png: cannot be read as a PNG"));
}

}  // namespace
