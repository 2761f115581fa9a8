// bench_neighbours [--seconds S] [--runs N] [--points N] [--json FILE]: builds a grid of lists of random points anew,
// and counts the neighbours within a radius of each point, about 20. Times are of replayed recordings, by device
// timestamps.
#include "bench_input.h"
#include "neighbours.glift.hpp"
#include "timing.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>

namespace {

struct Options {
    double seconds = 0.2, neighbours = 20;
    int runs = 5;
    std::uint32_t points = 1000000;
    std::string json;
};

/// The side of the cube with the points, in radii: a whole number, such that a point has about as many neighbours as
/// asked for.
std::uint32_t side_of(const Options& options) {
    const double inside = 4 * std::numbers::pi / 3;
    return static_cast<std::uint32_t>(std::lround(std::cbrt(options.points * inside / options.neighbours)));
}

std::vector<glift::float3> points_of(std::uint32_t n, std::uint32_t side) {
    std::vector<glift::float3> points(n);
    const auto along = [&](std::uint32_t i) {
        return static_cast<float>(side) * static_cast<float>(bench::hash32(i) >> 8) * 0x1p-24f;
    };
    for (std::uint32_t i = 0; i < n; ++i) points[i] = {along(3 * i), along(3 * i + 1), along(3 * i + 2)};
    return points;
}

nlohmann::ordered_json run_on(const glift::Device& device, const Options& options) {
    const std::uint32_t side = side_of(options), n = options.points;
    const glift::uint3 cells{side, side, side};
    neighbours::Points points(device, n);
    neighbours::Numbers cell(device, n), counts(device, n);
    neighbours::Grid grid(device, side * side * side, n);
    points.write(points_of(n, side));
    const auto build = [&](const glift::Commands& c) { neighbours::build(c, points, cells, cell, grid); };
    const auto count = [&](const glift::Commands& c) { neighbours::count_all(c, grid, cells, counts); };
    build(device);
    count(device);
    double found = 0;
    for (const std::uint32_t each : counts.read()) found += each - 1;
    const double building = bench::time_of(device, build, options.runs, options.seconds),
                 counting = bench::time_of(device, count, options.runs, options.seconds);
    std::printf("| %s | %u | %u^3 | %.1f | %.3f | %.3f |\n", device.properties().name.c_str(), n, side, found / n,
                1e3 * building, 1e3 * counting);
    std::fflush(stdout);
    return {{"device", device.properties().name},
            {"points", n},
            {"cells", side},
            {"neighbours", found / n},
            {"build_seconds", building},
            {"count_seconds", counting}};
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Neighbours within a radius, by a grid of lists that is built anew");
    Options options;
    app.add_option("--seconds", options.seconds, "of a run, about")->capture_default_str();
    app.add_option("--runs", options.runs, "of which the median counts")->capture_default_str();
    app.add_option("--points", options.points)->check(CLI::Range(1u, 1u << 24))->capture_default_str();
    app.add_option("--json", options.json, "where the figures go");
    CLI11_PARSE(app, argc, argv);
    try {
        std::printf("| device | points | cells | neighbours each | build, ms | count, ms |\n"
                    "| --- | ---: | ---: | ---: | ---: | ---: |\n");
        nlohmann::ordered_json all = nlohmann::ordered_json::array();
        const glift::Device device = glift::Device::open();
        all.push_back(run_on(device, options));
        if (!device.is_host()) all.push_back(run_on(glift::Device::open("host"), options));
        if (!options.json.empty()) std::ofstream(options.json) << all.dump(2) << "\n";
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_neighbours: %s\n", error.what());
        return 1;
    }
    return 0;
}
