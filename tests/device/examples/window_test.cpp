// The depth-of-field example in a window: what is seen is what a run without a window makes, also after a click, a move
// of a slider or a change of the window's size. Also what the program says if the display goes away or there is none.
#include "windows.h"

namespace {

using picture::Picture;
using testing::HasSubstr;
using windows::farthest;
using windows::rounding;
using windows::waited_for;
using windows::Windows;

const std::vector<std::string> small = {"--scene", "robot", "--size", "300", "200", "--layers", "2", "--focus", "3"};

TEST_F(Windows, ShowWhatARunWithoutOneMakes) {
    const Picture expected = headless(small);
    const auto running = started(small);
    const Seen with_sliders = settled({});
    keep(with_sliders, "window_sliders.png");
    EXPECT_GT(farthest(with_sliders, expected), 20) << "the sliders cover a part";
    display.type("Tab");
    EXPECT_TRUE(shows(expected)) << running->err();
    // Minimised and restored, it shows the same.
    display.minimise();
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    display.restore();
    EXPECT_TRUE(shows(expected)) << running->err();
    display.ask_to_close();
    EXPECT_EQ(running->exit_code(), 0) << running->err();
    EXPECT_EQ(farthest(with_sliders, said(*running)), farthest(with_sliders, expected));
}

TEST_F(Windows, AClickFocusesAndResizingDrawsAnew) {
    const auto running = started(small);
    display.type("Tab");
    ASSERT_TRUE(shows(headless(small))) << running->err();
    const Seen before = display.seen();
    display.move_to(280, 150);
    display.press();
    display.release();
    const Seen focused = settled(before);
    display.resize(260, 220);
    ASSERT_TRUE(waited_for([&] { return display.seen().width == 260; }));
    const Seen resized = settled(focused);
    keep(resized, "window_resized.png");
    display.type("Escape");
    EXPECT_EQ(running->exit_code(), 0) << running->err();
    EXPECT_LE(farthest(resized, said(*running)), rounding) << running->out();
    EXPECT_THAT(running->out(), HasSubstr("--size 260 220"));
    EXPECT_THAT(running->out(), testing::Not(HasSubstr("--focus 3 ")));
}

TEST_F(Windows, SlidersMoveWhatTheySay) {
    std::vector<std::string> large = small;
    large[3] = "480";
    large[4] = "300";
    const auto running = started(large);
    const Seen before = settled({});
    display.move_to(30, 45);  // on the f-stop's slider, at its left
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    display.press();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    display.release();
    keep(settled(before), "window_f_stop.png");
    display.type("Tab");
    display.move_to(400, 290);
    const Seen seen = settled(before);
    display.type("Escape");
    EXPECT_EQ(running->exit_code(), 0) << running->err();
    EXPECT_THAT(running->out(), testing::Not(HasSubstr("--f-stop 2 "))) << "it was moved";
    EXPECT_THAT(running->out(), HasSubstr("--focus 3 ")) << "the press was the slider's";
    EXPECT_LE(farthest(seen, said(*running)), rounding) << running->out();
}

TEST_F(Windows, SayThatTheDisplayIsGone) {
    const auto running = started(small);
    settled({});
    display.end();
    EXPECT_EQ(running->exit_code(), 1) << running->err();
    EXPECT_THAT(running->err(), HasSubstr("gone"));
    EXPECT_THAT(running->err(), HasSubstr("remedy: start the program again"));
}

TEST(NoWindow, SaysThatThereIsNoDisplay) {
    for (const char* name : {"DISPLAY=", "DISPLAY=:4242"}) {
        const auto result = run_example(GLIFT_DEPTH_OF_FIELD, {"--window"}, {name});
        EXPECT_EQ(result.exit_code, 1);
        EXPECT_THAT(result.err, HasSubstr("there is no display to open a window on"));
        EXPECT_THAT(result.err, HasSubstr("no display: set DISPLAY, or leave --window out"));
    }
    const auto host =
        run_example(GLIFT_DEPTH_OF_FIELD, {"--size", "8", "8", "--out", "/dev/null/no.png"}, {"DISPLAY="});
    EXPECT_THAT(host.err, testing::Not(HasSubstr("display"))) << "without a window none is asked for";
}

}  // namespace
