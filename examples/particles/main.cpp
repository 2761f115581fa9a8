// Simulates a fluid of particles by fluid.glift, and writes pictures. Each step finds the neighbours of each particle
// anew.
// --particles is about how many particles there are, a cube of them: by default a million on a GPU, 20,000 elsewhere.
#include "../common/camera.h"
#include "../common/picture.h"
#include "../common/progress.h"
#include "fluid.glift.hpp"
#include "fluid_picture.glift.hpp"

#include <glift/host/math.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

namespace {

using glift::float3, glift::uint3;

struct Arguments {
    std::uint32_t particles = 0, steps = 0, every = 0, width = 960;
    std::filesystem::path out = ".";
};

Arguments read_arguments(CLI::App& app, int argc, char** argv) {
    Arguments a;
    app.description("A block of fluid falls, flows around a ball, and comes back from the other side of a tank.");
    app.add_option("--particles", a.particles,
                   "about so many, a cube; without it 1000000 on a GPU, 20000 elsewhere, and 16777216 at most")
        ->check(CLI::Range(8u, 1u << 24));
    app.add_option("--steps", a.steps, "without it as many as the wave takes there and back");
    app.add_option("--every", a.every, "steps between two pictures; without it 12 pictures in all");
    app.add_option("--width", a.width, "of a picture, half as high")->check(CLI::Range(32u, 8192u));
    app.add_option("--out", a.out, "folder of the pictures")->capture_default_str();
    app.parse(argc, argv);
    return a;
}

/// The initial state: a cube of fluid at one end of a tank that is three times as long, and a ball as an obstacle.
struct Scene {
    std::uint32_t side;  ///< the cube's side, in particles
    uint3 tank;
    fluid::Motion motion;

    explicit Scene(std::uint32_t particles)
        : side(static_cast<std::uint32_t>(std::lround(std::cbrt(static_cast<double>(particles))))) {
        const float unit = 0.5f * static_cast<float>(side);
        const auto cells = [&](float units) { return static_cast<std::uint32_t>(std::ceil(units * unit)); };
        tank = {cells(3), cells(1.6f), cells(1) + 1};
        // Gravity is such that a fall by the cube's height gives a speed of 10, whatever the cube's size.
        motion = {{{1.75f * unit, 0.3f * unit, 0.5f * unit}, 0.26f * unit}, {0, -50 / unit, 0}, 0.02f, 0.04f};
    }

    std::uint32_t particles() const { return side * side * side; }
    std::uint32_t steps() const { return 14 * side; }
};

fluid_picture::Viewpoint view_of(const Scene& scene) {
    const float3 box{static_cast<float>(scene.tank.x), static_cast<float>(scene.tank.y),
                     static_cast<float>(scene.tank.z)};
    camera::Camera eye;
    eye.target = {0.52f * box.x, 0.27f * box.y, 0.5f * box.z};
    eye.eye = eye.target + float3{0.22f, 0.62f, 1.0f} * (0.98f * box.x);
    eye.height_angle = 0.56f;
    eye.near = 0.1f * box.x;
    eye.far = 3.0f * box.x;
    const float3 forward = glift::normalize(eye.target - eye.eye),
                 right = glift::normalize(glift::cross(forward, eye.up));
    return {camera::projection_of(eye, 2.0f),
            eye.eye,
            right,
            glift::cross(right, forward),
            forward,
            glift::normalize(float3{-0.3f, 1.0f, 0.55f}),
            0.27f};
}

class Run {
public:
    Run(glift::Device device, const Arguments& arguments)
        : arguments_(arguments), device_(std::move(device)),
          scene_(arguments.particles                                   ? arguments.particles
                 : device_.properties().kind == glift::DeviceKind::gpu ? 1000000u
                                                                       : 20000u),
          fluid_(device_, scene_.tank, scene_.particles()), picture_(device_, {arguments.width, arguments.width / 2}) {
        if (!arguments_.steps) arguments_.steps = scene_.steps();
        if (!arguments_.every) arguments_.every = std::max(1u, arguments_.steps / 12);
        fluid::pour(device_, fluid_, {0, 0, 0.5f}, {scene_.side, scene_.side, scene_.side});
        step_ = device_.record([&](const glift::Commands& commands) { fluid_.step(commands, scene_.motion); });
    }

    void run() {
        progress::Line line("step");
        std::string last;
        draw(0);
        std::uint64_t submissions = 0, waits = 0;
        for (std::uint32_t done = 0; done < arguments_.steps;) {
            const std::uint32_t first = done, until = std::min(arguments_.steps, done + arguments_.every);
            device_.wait();
            const auto start = std::chrono::steady_clock::now();
            const glift::Statistics before = device_.statistics();
            for (; done < until; ++done) step_.submit();
            submissions += device_.statistics().submissions - before.submissions;
            waits += device_.statistics().waits - before.waits;
            device_.wait();
            const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
            char text[64];
            std::snprintf(text, sizeof text, "%u particles, %.2f ms a step", scene_.particles(),
                          1e3 * taken.count() / (done - first));
            last = text;
            line.show(done, arguments_.steps, last);
            draw(done);
        }
        line.clear();
        if (!last.empty()) std::printf("at the end: %s\n", last.c_str());
        std::printf("%s: %u steps, %llu submissions, %llu waits\n", device_.properties().name.c_str(), arguments_.steps,
                    static_cast<unsigned long long>(submissions), static_cast<unsigned long long>(waits));
    }

private:
    void draw(std::uint32_t step) {
        const float3 box{static_cast<float>(scene_.tank.x), static_cast<float>(scene_.tank.y),
                         static_cast<float>(scene_.tank.z)};
        fluid_picture::render(device_, fluid_.particles(), scene_.motion.ball, box, view_of(scene_), picture_);
        char name[32];
        std::snprintf(name, sizeof name, "fluid_%04u.png", step);
        picture::write((arguments_.out / name).string(), {arguments_.width, arguments_.width / 2, picture_.read(), {}});
    }

    Arguments arguments_;
    glift::Device device_;
    Scene scene_;
    fluid::Fluid fluid_;
    fluid_picture::Colour picture_;
    glift::Recording step_;
};

}  // namespace

int main(int argc, char** argv) {
    CLI::App app;
    try {
        const Arguments arguments = read_arguments(app, argc, argv);
        std::filesystem::create_directories(arguments.out);
        Run(glift::Device::open(), arguments).run();
        return 0;
    } catch (const CLI::ParseError& error) {
        return app.exit(error);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "particles: %s\n", error.what());
        return 1;
    }
}
