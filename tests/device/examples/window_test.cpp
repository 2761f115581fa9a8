// Uses the depth-of-field example in a window, on a virtual display: the window must show what a run without a window
// computes. Validation is on, and ends the example if it reports something.
#include "run_example.h"
#include "virtual_display.h"

#include "examples/common/picture.h"

#include <gmock/gmock.h>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <thread>

namespace {

using picture::Picture;
using testing::HasSubstr;

/// Waits until the condition holds; false after half a minute.
template <class Condition> bool waited_for(const Condition& condition) {
    const auto start = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - start < std::chrono::seconds(30)) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
}

/// A program that runs in parallel to the test.
class Running {
public:
    Running(const std::string& out, const std::string& err, std::vector<std::string> words)
        : out_(out), err_(err), process_(fork()) {
        if (process_ != 0) return;
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (!std::freopen(out_.c_str(), "w", stdout) || !std::freopen(err_.c_str(), "w", stderr)) _exit(126);
        std::vector<char*> arguments;
        for (std::string& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        execvp(arguments[0], arguments.data());
        _exit(127);
    }
    ~Running() {
        if (process_ == 0) return;
        kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }
    Running(const Running&) = delete;

    /// Waits for the program's end; -1 if it does not end, or a signal ended it.
    int exit_code() {
        int status = 0;
        const bool has_ended = waited_for([&] { return waitpid(process_, &status, WNOHANG) == process_; });
        if (has_ended) process_ = 0;
        return has_ended && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    std::string out() const { return glift::test::read_file(out_); }
    std::string err() const { return glift::test::read_file(err_); }

private:
    std::string out_, err_;
    int process_;
};

/// The largest difference of a channel, in steps of 8-bit colour; 255 where the sizes differ.
double farthest(const Seen& seen, const Picture& picture) {
    if (seen.width != picture.width || seen.height != picture.height) return 255;
    const auto coded = [](float x) {
        x = std::clamp(x, 0.0f, 1.0f);
        return 255 * (x <= 0.0031308f ? x * 12.92f : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f);
    };
    double most = 0;
    for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
        const glift::float4& p = picture.pixels[i];
        const Seen::Colour& c = seen.pixels[i];
        for (const auto& [here, there] : {std::pair(c.red, p.x), std::pair(c.green, p.y), std::pair(c.blue, p.z)})
            most = std::max(most, std::abs(static_cast<double>(here) - static_cast<double>(coded(there))));
    }
    return most;
}

/// The largest difference that rounding to eight bits explains: both pictures are rounded.
constexpr double rounding = 1.01;

struct Windows : testing::Test {
    glift::test::TemporaryFolder folder;
    VirtualDisplay display;

    std::string file(const std::string& name) const { return folder.path() / name; }
    std::unique_ptr<Running> started(const std::vector<std::string>& arguments) {
        std::vector<std::string> words = {"env",
                                          "DISPLAY=" + display.name(),
                                          "GLIFT_DEVICE=lavapipe",
                                          "GLIFT_VALIDATE=1",
                                          "LP_NUM_THREADS=1",
                                          "MESA_SHADER_CACHE_DIR=" GLIFT_CACHES "/mesa",
                                          "GLIFT_CACHE_DIR=" GLIFT_CACHES "/pipelines",
                                          "ASAN_OPTIONS=detect_leaks=0",
                                          GLIFT_DEPTH_OF_FIELD,
                                          "--window"};
        words.insert(words.end(), arguments.begin(), arguments.end());
        auto running = std::make_unique<Running>(file("out"), file("err"), words);
        EXPECT_TRUE(waited_for([&] { return display.has_window("Depth of field"); })) << running->err();
        return running;
    }
    Picture headless(std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--out", file("headless.png")});
        const auto result = run_example(GLIFT_DEPTH_OF_FIELD, arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return picture::read(file("headless.png"));
    }
    /// The program prints the arguments with which a run without a window makes the same picture. Returns that run's
    /// picture.
    Picture said(const Running& running) {
        const std::string out = running.out(), before = "the same picture: depth_of_field ";
        const std::size_t at = out.find(before);
        EXPECT_NE(at, std::string::npos) << out << running.err();
        if (at == std::string::npos) return {};
        std::istringstream words(out.substr(at + before.size()));
        std::vector<std::string> arguments;
        for (std::string word; words >> word;) arguments.push_back(word);
        arguments.resize(arguments.size() - 2);  // its --out
        return headless(arguments);
    }
    bool shows(const Picture& picture) {
        return waited_for([&] { return farthest(display.seen(), picture) <= rounding; });
    }
    /// Waits for a picture that stays the same for some frames and differs from `other`.
    Seen settled(const Seen& other) {
        Seen last;
        unsigned same = 0;
        EXPECT_TRUE(waited_for([&] {
            Seen now = display.seen();
            const bool is_black = std::all_of(now.pixels.begin(), now.pixels.end(),
                                              [](const Seen::Colour& c) { return c.red + c.green + c.blue < 30; });
            same = !is_black && now.pixels == last.pixels && now.pixels != other.pixels ? same + 1 : 0;
            last = std::move(now);
            return same > 10;
        }));
        return last;
    }
    void keep(const Seen& seen, const char* name) const {
        Picture picture{seen.width, seen.height, {}, {}};
        const auto linear = [](std::uint8_t byte) {
            const float x = static_cast<float>(byte) / 255;
            return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
        };
        for (const Seen::Colour& c : seen.pixels)
            picture.pixels.emplace_back(linear(c.red), linear(c.green), linear(c.blue), 1.0f);
        picture::write(std::string(GLIFT_CACHES) + "/" + name, picture);
    }
};

const std::vector<std::string> small = {"--scene", "robot", "--size", "300", "200", "--layers", "2", "--focus", "3"};

TEST_F(Windows, ShowWhatARunWithoutOneMakes) {
    const Picture expected = headless(small);
    const auto running = started(small);
    const Seen with_sliders = settled({});
    keep(with_sliders, "window_sliders.png");
    EXPECT_GT(farthest(with_sliders, expected), 20) << "the sliders cover a part";
    display.type("Tab");
    EXPECT_TRUE(shows(expected)) << running->err();
    // After it was minimised and restored, the window shows the same.
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
