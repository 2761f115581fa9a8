// Smoke in pages that follow it: smoke.glift from C++.
#include "../common/picture.h"
#include "../common/progress.h"
#include "smoke.glift.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

namespace {

struct Arguments {
    std::uint32_t extent = 512, steps = 400, every = 100, rounds = 20, pages = 1024;
    std::filesystem::path out = ".";
};

Arguments read_arguments(CLI::App& app, int argc, char** argv) {
    Arguments a;
    app.description("Smoke that rises from a disk, in pages of 16 x 16 cells where there is smoke.");
    app.add_option("--extent", a.extent, "cells along each side of the domain")
        ->check(CLI::Range(64u, 8192u))
        ->capture_default_str();
    app.add_option("--steps", a.steps, "of the simulation")->capture_default_str();
    app.add_option("--every", a.every, "steps between two pictures")
        ->check(CLI::Range(1u, 1000000u))
        ->capture_default_str();
    app.add_option("--rounds", a.rounds, "pairs of Jacobi sweeps in a step")->capture_default_str();
    app.add_option("--pages", a.pages, "that there may be at once")->capture_default_str();
    app.add_option("--out", a.out, "folder of the pictures")->capture_default_str();
    app.parse(argc, argv);
    return a;
}

/// Grey smoke before dark blue, darker where no page is.
picture::Picture coloured(std::uint32_t extent, const std::vector<float>& densities) {
    picture::Picture picture{extent, extent, {}, {}};
    for (const float density : densities) {
        const float paper = density < 0 ? 0.01f : 0.03f, smoke = std::clamp(density, 0.0f, 1.0f);
        picture.pixels.push_back({paper + 0.8f * smoke, paper + 0.8f * smoke, 2 * paper + 0.75f * smoke, 1.0f});
    }
    return picture;
}

/// False: pages found no room.
bool run(const Arguments& a) {
    const glift::Device device = glift::Device::open();
    smoke::Smoke grid(device, {a.extent, a.extent}, a.pages);
    smoke::Picture densities(device, {a.extent, a.extent});
    const float side = static_cast<float>(a.extent);
    progress::Line line("step");
    for (std::uint32_t step = 1; step <= a.steps; ++step) {
        smoke::step(device, grid, {0.5f * side, 0.85f * side}, 0.04f * side, 1.0f, a.rounds);
        if (step % a.every != 0 && step != a.steps) continue;
        const auto status = grid.status(device);
        if (status.refused != 0) return false;
        line.show(step, a.steps, std::to_string(status.resident) + " pages");
        smoke::draw(device, grid.now().density(), densities);
        char name[32];
        std::snprintf(name, sizeof name, "smoke_%05u.png", step);
        picture::write((a.out / name).string(), coloured(a.extent, densities.read()));
    }
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app;
    try {
        const Arguments arguments = read_arguments(app, argc, argv);
        std::filesystem::create_directories(arguments.out);
        if (run(arguments)) return 0;
        std::fprintf(stderr, "smoke: pages found no room: give more of them by --pages\n");
    } catch (const CLI::ParseError& error) {
        return app.exit(error);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "smoke: %s\n", error.what());
    }
    return 1;
}
