// Runs examples in windows, as a person uses them, on lavapipe and a virtual display. Validation is on, and ends the
// example where it finds something.
#pragma once

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

namespace windows {

using picture::Picture;

/// Waits until the condition holds; false if it does not within half a minute.
template <class Condition> inline bool waited_for(const Condition& condition) {
    const auto start = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - start < std::chrono::seconds(30)) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
}

/// A program that runs beside the test.
class Running {
public:
    Running(const std::string& out, const std::string& err, std::vector<std::string> words)
        : out_(out), err_(err), process_(fork()) {
        if (process_ < 0) throw std::runtime_error("no process can be started");
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

    /// Waits for the program's end. -1 if that does not come within half a minute, or if a signal ended it.
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

/// The largest difference of a channel, in 255ths of white; 255 where the sizes differ.
inline double farthest(const Seen& seen, const Picture& picture) {
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

/// How far a window and a picture of the same contents may differ (`farthest`): both are rounded to eight bits.
inline constexpr double rounding = 1.01;

/// An example in a window with a title.
struct Windows : testing::Test {
    explicit Windows(const char* program = GLIFT_DEPTH_OF_FIELD, const char* title = "Depth of field",
                     const char* said = "the same picture: depth_of_field ")
        : program_(program), title_(title), said_(said) {}

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
                                          program_,
                                          "--window"};
        words.insert(words.end(), arguments.begin(), arguments.end());
        auto running = std::make_unique<Running>(file("out"), file("err"), words);
        EXPECT_TRUE(waited_for([&] { return display.has_window(title_); })) << running->err();
        return running;
    }
    Picture headless(std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--out", file("headless.png")});
        const auto result = run_example(program_, arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return picture::read(file("headless.png"));
    }
    /// Runs the command that the program printed as making the same picture; returns its picture.
    Picture said(const Running& running) {
        const std::string out = running.out();
        const std::size_t at = out.find(said_);
        EXPECT_NE(at, std::string::npos) << out << running.err();
        if (at == std::string::npos) return {};
        std::istringstream words(out.substr(at + std::string(said_).size()));
        std::vector<std::string> arguments;
        for (std::string word; words >> word;) arguments.push_back(word);
        arguments.resize(arguments.size() - 2);  // its --out
        return headless(arguments);
    }
    bool shows(const Picture& picture) {
        return waited_for([&] { return farthest(display.seen(), picture) <= rounding; });
    }
    /// Waits until the window is not black, differs from `other`, and has stayed so for 0.3 s, or for twice the time
    /// that this or an earlier call took until then if that is longer, as on a busy machine; returns its pixels.
    Seen settled(const Seen& other) {
        const Clock::time_point start = Clock::now();
        Clock::time_point changed = start;
        Seen last;
        EXPECT_TRUE(waited_for([&] {
            Seen now = display.seen();
            const bool is_black = std::all_of(now.pixels.begin(), now.pixels.end(),
                                              [](const Seen::Colour& c) { return c.red + c.green + c.blue < 30; });
            if (is_black || now.pixels != last.pixels || now.pixels == other.pixels) {
                changed = Clock::now();
                slowest_ = std::max(slowest_, changed - start);
            }
            last = std::move(now);
            return Clock::now() - changed > std::max<Clock::duration>(std::chrono::milliseconds(300), 2 * slowest_);
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
        picture::write(std::string(GLIFT_CACHES "/").append(name), picture);
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::duration slowest_{};
    const char *program_, *title_, *said_;
};

}  // namespace windows
