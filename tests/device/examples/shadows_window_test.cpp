// The shadows example in a window: what is seen is what a run without a window makes, drags turn the camera and the
// light, the panel chooses what is shown, and a key saves the picture that is seen.
#include "windows.h"

#include <filesystem>

namespace {

using windows::farthest;
using windows::waited_for;

struct ShadowsWindows : windows::Windows {
    ShadowsWindows() : Windows(GLIFT_SHADOWS, "Shadows", "") {
        // Few triangles, so that frames follow each other faster than a person's moves.
        glift::test::write_file(file("tent.obj"), "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0.5 0.8 0.5\n"
                                                  "f 1 5 2\nf 2 5 3\nf 3 5 4\nf 4 5 1\n");
    }

    const std::vector<std::string> small = {"--scene", file("tent.obj"), "--size", "300",     "200",   "--levels",
                                            "8",       "--pages",        "512",    "--pairs", "20000", "--standard",
                                            "128"};

    std::vector<std::string> with(std::vector<std::string> more) const {
        more.insert(more.begin(), small.begin(), small.end());
        return more;
    }
    /// Waits until the window differs from `picture`, which is without the panel (the first frame has none yet), and
    /// then until it no longer changes; returns what it shows.
    Seen with_panel(const picture::Picture& picture) {
        EXPECT_TRUE(waited_for([&] { return farthest(display.seen(), picture) > 20; }));
        return settled({});
    }
    static void wait() { std::this_thread::sleep_for(std::chrono::milliseconds(60)); }
    void drag(unsigned button, int from_x, int from_y, int to_x, int to_y) const {
        display.move_to(from_x, from_y);
        wait();
        display.press(button);
        wait();
        display.move_to((from_x + to_x) / 2, (from_y + to_y) / 2);
        wait();
        display.move_to(to_x, to_y);
        wait();
        display.release(button);
    }
    /// Moves, presses and releases with pauses in which several frames are drawn, also on a busy machine: the panel
    /// looks at the pointer once a frame.
    void click(int x, int y) const {
        const auto some_frames = [] { std::this_thread::sleep_for(std::chrono::milliseconds(800)); };
        display.move_to(x, y);
        some_frames();
        display.press();
        some_frames();
        display.release();
        some_frames();
    }
};

TEST_F(ShadowsWindows, DragsTurnCameraAndLightAndSIsAPictureOfIt) {
    const picture::Picture expected = headless(small);
    const auto running = started(with({"--out", file("seen.png")}));
    keep(with_panel(expected), "shadows_window_panel.png");
    display.type("Tab");
    ASSERT_TRUE(shows(expected)) << running->err();
    const Seen before = display.seen();
    drag(1, 200, 100, 160, 110);
    const Seen turned = settled(before);
    drag(3, 200, 100, 120, 100);
    const Seen lit = settled(turned);
    EXPECT_GT(farthest(lit, expected), 20);
    display.type("s");
    ASSERT_TRUE(waited_for([&] { return std::filesystem::exists(file("seen.png")); })) << running->err();
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    EXPECT_TRUE(shows(picture::read(file("seen.png")))) << running->err();
    display.type("Escape");
    EXPECT_EQ(running->exit_code(), 0) << running->err();
}

TEST_F(ShadowsWindows, ThePanelChoosesWhatIsShown) {
    const picture::Picture expected = headless(small);
    const auto running = started(small);
    const Seen before = with_panel(expected);
    click(60, 69);  // the list "show", below the list "method"
    keep(settled(before), "shadows_window_views.png");
    click(60, 111);  // the entry "levels" of the opened list, below "picture"
    display.type("Tab");
    EXPECT_TRUE(shows(headless(with({"--show", "levels"})))) << running->err();
    keep(display.seen(), "shadows_window_levels.png");
    display.ask_to_close();
    EXPECT_EQ(running->exit_code(), 0) << running->err();
}

}  // namespace
