// A front that moves through a large domain, of which only the pages near the front are resident: front.glift from C++.
#include "../common/picture.h"
#include "../common/progress.h"
#include "front.glift.hpp"
#include "front_picture.glift.hpp"

#ifdef WITH_FILES
#include <glift/files.h>
#endif
#include <glift/host/math.h>

#include <CLI/CLI.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <random>
#include <string>

namespace {

using glift::float3, glift::uint3;

constexpr float far = 8;  ///< equals `far` in front.glift

struct Arguments {
    std::uint32_t extent = 1024, steps = 240, every = 10, balls = 14, pages = 100000, size = 640;
    std::uint64_t seed = 4;
    std::filesystem::path out = ".";
    std::string from, save;
};

Arguments read_arguments(CLI::App& app, int argc, char** argv) {
    Arguments a;
    app.description("A front of spheres that grow, merge and are whirled, as a distance field in pages near it.");
    app.add_option("--extent", a.extent, "elements along each side of the domain")
        ->check(CLI::Range(32u, 4096u))
        ->capture_default_str();
    app.add_option("--steps", a.steps, "of about half an element at most")->capture_default_str();
    app.add_option("--every", a.every, "steps between two pictures; 0: only the first and the last one")
        ->capture_default_str();
    app.add_option("--balls", a.balls, "at the beginning")->check(CLI::Range(1u, 1000u))->capture_default_str();
    app.add_option("--pages", a.pages, "that there may be at once")->capture_default_str();
    app.add_option("--size", a.size, "of a picture's side")->check(CLI::Range(16u, 8192u))->capture_default_str();
    app.add_option("--seed", a.seed, "of the places of the balls")->capture_default_str();
    app.add_option("--out", a.out, "folder of the pictures")->capture_default_str();
#ifdef WITH_FILES
    app.add_option("--save", a.save, "a file for the band after the last step");
    app.add_option("--from", a.from, "goes on with a band that --save wrote, in place of balls")
        ->check(CLI::ExistingFile);
#endif
    app.parse(argc, argv);
    return a;
}

/// Random balls whose centres are 0.06 to 0.24 extents from the axis of the rotation, which is fastest at 0.26.
std::vector<front::Ball> balls_of(const Arguments& a) {
    std::mt19937_64 random(a.seed);
    const auto between = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(random() >> 40) / static_cast<float>(1 << 24);
    };
    std::vector<front::Ball> balls(a.balls);
    const float extent = static_cast<float>(a.extent), middle = 0.5f * extent;
    for (front::Ball& ball : balls) {
        const float angle = between(0, 2 * std::numbers::pi_v<float>), from = between(0.06f, 0.24f) * extent;
        ball = {{middle + from * std::cos(angle), middle + from * std::sin(angle),
                 middle + between(-0.12f, 0.12f) * extent},
                between(0.02f, 0.06f) * extent};
    }
    return balls;
}

/// The band of the file --from, or one without pages.
band::Band band_of(const glift::Device& device, const Arguments& a) {
#ifdef WITH_FILES
    if (!a.from.empty()) return glift::load<band::Band>(a.from, "band", device);
#endif
    return {device, {a.extent, a.extent, a.extent}, a.pages, {far, far}};
}

front_picture::Viewpoint view_of(std::uint32_t extent) {
    const float side = static_cast<float>(extent);
    const float3 middle{0.5f * side, 0.5f * side, 0.5f * side}, eye{0.5f * side, -0.45f * side, 1.15f * side};
    const float3 forward = glift::normalize(middle - eye), right{1, 0, 0};
    const float3 down = glift::cross(forward, right);
    return {eye, forward, right, down, 0.27f, glift::normalize(float3{-0.5f, -0.6f, 0.7f})};
}

/// A run of the simulation, with the pictures that it writes.
class Run {
public:
    Run(glift::Device device, const Arguments& arguments)
        : arguments_(arguments), device_(std::move(device)), band_(band_of(device_, arguments)),
          picture_(device_, {arguments.size, arguments.size}) {
        arguments_.extent = band_.domain().x;
        if (arguments.from.empty()) begin();
        most_refused_ = band_.status(device_).refused;
        const float middle = 0.5f * static_cast<float>(arguments_.extent);
        const front::Motion motion{{middle, middle, middle}, 0.9f * middle, 0.35f, 0.15f};
        step_ = device_.record([&](const glift::Commands& commands) { front::step(commands, band_, motion); });
    }

    void run() {
        draw(0);
        std::uint64_t submissions = 0, waits = 0;
        for (std::uint32_t done = 0; done < arguments_.steps;) {
            const std::uint32_t until =
                arguments_.every ? std::min(arguments_.steps, done + arguments_.every) : arguments_.steps;
            device_.wait();
            const auto start = std::chrono::steady_clock::now();
            const glift::Statistics before = device_.statistics();
            const std::uint32_t first = done;
            for (; done < until; ++done) step_.submit();
            submissions += device_.statistics().submissions - before.submissions;
            waits += device_.statistics().waits - before.waits;
            device_.wait();
            report(done,
                   std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / (done - first));
            draw(done);
        }
        line_.clear();
#ifdef WITH_FILES
        if (!arguments_.save.empty()) glift::save(arguments_.save, "band", band_);
#endif
        if (!last_.empty()) std::printf("at the end: %s\n", last_.c_str());
        std::printf("%s: %u steps, %llu submissions, %llu waits\n", device_.properties().name.c_str(), arguments_.steps,
                    static_cast<unsigned long long>(submissions), static_cast<unsigned long long>(waits));
    }

    /// Whether the pool had room for all pages whenever that was checked: after the first allocation and at each
    /// report.
    bool is_whole() const { return most_refused_ == 0; }

private:
    void begin() {
        const std::vector<front::Ball> balls = balls_of(arguments_);
        front::Balls given(device_, static_cast<glift::uint>(balls.size()));
        given.write(balls);
        for (const front::Ball& ball : balls) front::ask_near(device_, band_, ball);
        front::begin(device_, band_, given);
    }

    void report(std::uint32_t done, double seconds) {
        const auto status = band_.status(device_);
        most_refused_ = std::max(most_refused_, status.refused);
        const double all = std::pow(static_cast<double>(arguments_.extent) / 8, 3);
        char text[128];
        std::snprintf(text, sizeof text, "%u pages (%.2f %% of the domain), %u came with the last step, %.2f ms a step",
                      status.resident, 100 * status.resident / all, status.granted, 1e3 * seconds);
        last_ = text;
        line_.show(done, arguments_.steps, last_);
    }

    void draw(std::uint32_t step) {
        char number[16];
        std::snprintf(number, sizeof number, "%04u.png", step);
        front_picture::shade(device_, band_.now(), view_of(arguments_.extent), picture_);
        write(arguments_.out / (std::string("front_") + number));
        const std::uint32_t shown = std::min(arguments_.size, arguments_.extent);
        const uint3 first{(arguments_.extent - shown) / 2, (arguments_.extent - shown) / 2, arguments_.extent / 2};
        front_picture::slice(device_, band_.now(), first,
                             static_cast<float>(shown) / static_cast<float>(arguments_.size), picture_);
        write(arguments_.out / (std::string("slice_") + number));
    }

    void write(const std::filesystem::path& file) {
        picture::write(file.string(), {arguments_.size, arguments_.size, picture_.read(), {}});
    }

    Arguments arguments_;
    glift::Device device_;
    band::Band band_;
    front_picture::Picture picture_;
    glift::Recording step_;
    std::uint32_t most_refused_ = 0;
    progress::Line line_{"step"};
    std::string last_;  ///< what was reported last
};

}  // namespace

int main(int argc, char** argv) {
    CLI::App app;
    try {
        const Arguments arguments = read_arguments(app, argc, argv);
        std::filesystem::create_directories(arguments.out);
        Run run(glift::Device::open(), arguments);
        run.run();
        if (!run.is_whole()) {
            std::fprintf(stderr, "narrow_band: pages found no room: give more of them by --pages\n");
            return 1;
        }
        return 0;
    } catch (const CLI::ParseError& error) {
        return app.exit(error);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "narrow_band: %s\n", error.what());
        return 1;
    }
}
