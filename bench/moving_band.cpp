// bench_moving_band [--seconds S] [--steps N] [--runs N] [--json FILE]: the pages around a moving spherical shell
// (examples/narrow_band), for three domain sizes with the same shell, and for 1024^3 with a shell whose radius is in
// proportion to the domain. The shell shrinks for 32 steps, then grows again for 32: a period. A "change" of topology
// allocates and releases pages; a step is a change and two stencils over the resident pages. Times are of replayed
// recordings, by device timestamps.
//
// Costs that grow with the domain are measured apart: `tables` is a change without `ask` in a domain in which no page
// is requested, which leaves only the bit sets and scans over all pages. `ask`, part of each change, requests the pages
// that are needed next, testing only resident pages and their neighbours; `everywhere` tests all pages of the domain.
#include "moving_shell.glift.hpp"
#include "timing.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <string>

namespace {

struct Case {
    std::uint32_t side;
    float radius;
};

constexpr Case cases[] = {{256, 0.39f * 256}, {512, 0.39f * 256}, {1024, 0.39f * 256}, {1024, 0.39f * 1024}};
constexpr std::uint32_t same_surface = 3;  ///< how many cases, from the first on, have the same surface
constexpr float largest_growth = 16;       ///< of the radius during a period, in elements

struct Times {
    std::uint32_t pages = 0;
    std::uint64_t passes = 0;  ///< passes of one change
    double ask = 0, everywhere = 0, tables = 0, change = 0, stencils = 0, step = 0;
};

struct Options {
    double seconds = 0.2;
    int runs = 5;
    std::uint32_t steps = 64;
    std::string json;
};

std::uint32_t capacity_of(float radius) {
    const float r = radius + largest_growth;
    return static_cast<std::uint32_t>(4 * std::numbers::pi_v<float> * r * r * 2 * 9.6f / 512 * 1.1f) + 256;
}

Times measure(const glift::Device& device, const Case& one, const Options& options) {
    const glift::uint3 extent{one.side, one.side, one.side};
    band::Band band(device, extent, capacity_of(one.radius)), nothing(device, extent, 1);
    moving_shell::Clock clock(device, 1);
    moving_shell::begin(device, band, clock, one.radius);
    const auto time = [&](const std::function<void(const glift::Commands&)>& work) {
        return bench::time_of(device, work, options.runs, options.seconds);
    };
    Times times;
    const auto once =
        device.record([&](const glift::Commands& c) { moving_shell::change(c, band, clock, one.radius); });
    const std::uint64_t before = device.statistics().passes;
    once.submit();
    device.wait();
    times.passes = device.statistics().passes - before;
    // Every run takes the same steps, centred on the middle of the period: it ends at the radius with which it began
    // (half an element from it, if the number of steps is odd), so that `ask` of the next run finds the pages that it
    // needs beside resident ones.
    const auto time_steps = [&](const std::function<void(const glift::Commands&)>& work) {
        moving_shell::set(device, clock, 32 - options.steps / 2);
        moving_shell::ask_everywhere(device, band, clock, one.radius);
        band.update(device);
        return time([&](const glift::Commands& c) {
                   moving_shell::set(c, clock, 32 - options.steps / 2);
                   for (std::uint32_t step = 0; step < options.steps; ++step) work(c);
               }) /
               options.steps;
    };
    times.step = time_steps([&](const glift::Commands& c) { moving_shell::step(c, band, clock, one.radius); });
    times.change = time_steps([&](const glift::Commands& c) {
        moving_shell::change(c, band, clock, one.radius);
        moving_shell::tick(c, clock);
    });
    times.tables = time([&](const glift::Commands& c) { nothing.update(c); });
    // The times below are measured with the pages that are resident in the middle of a period.
    moving_shell::set(device, clock, 32);
    moving_shell::ask_everywhere(device, band, clock, one.radius);
    band.update(device);
    times.stencils = time([&](const glift::Commands& c) { moving_shell::stencils(c, band); });
    const auto status = band.status(device);
    if (status.refused) throw std::runtime_error("the pool is too small");
    times.pages = status.resident;
    times.ask = time([&](const glift::Commands& c) { moving_shell::ask(c, band, clock, one.radius); });
    times.everywhere =
        time([&](const glift::Commands& c) { moving_shell::ask_everywhere(c, band, clock, one.radius); });
    return times;
}

void print(const Case& one, const Times& times) {
    std::printf("| %u^3, r %.0f | %u | %llu |", one.side, one.radius, times.pages,
                static_cast<unsigned long long>(times.passes));
    for (const double seconds : {times.everywhere, times.ask, times.tables, times.change, times.stencils, times.step,
                                 times.step - times.tables})
        std::printf(" %.3f |", seconds * 1e3);
    std::printf("\n");
    std::fflush(stdout);
}

/// The largest time over the smallest among the cases with the same surface; of `part`, less `without` if given.
double spread(const std::vector<Times>& all, double Times::*part, double Times::*without) {
    double least = 1e9, most = 0;
    for (std::size_t i = 0; i < same_surface; ++i) {
        const double time = all[i].*part - (without ? all[i].*without : 0);
        least = std::min(least, time);
        most = std::max(most, time);
    }
    return most / least;
}

nlohmann::ordered_json run_on(const glift::Device& device, const Options& options) {
    std::printf("%s, ms:\n\n| domain | pages | passes of topology | everywhere | ask | tables | topology | two "
                "stencils | step | without tables |\n"
                "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n",
                device.properties().name.c_str());
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    std::vector<Times> all;
    for (const Case& one : cases) {
        const Times times = measure(device, one, options);
        print(one, times);
        all.push_back(times);
        rows.push_back({{"side", one.side},
                        {"radius", one.radius},
                        {"pages", times.pages},
                        {"topology_passes", times.passes},
                        {"ask_seconds", times.ask},
                        {"everywhere_seconds", times.everywhere},
                        {"tables_seconds", times.tables},
                        {"topology_seconds", times.change},
                        {"stencils_seconds", times.stencils},
                        {"step_seconds", times.step}});
    }
    const double with = spread(all, &Times::step, nullptr), without = spread(all, &Times::step, &Times::tables);
    std::printf("\nSame surface, largest over smallest: %.2f; without tables %.2f\n\n", with, without);
    return {{"device", device.properties().name}, {"rows", rows}, {"spread", with}, {"spread_without_tables", without}};
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("A moving band: topology and stencils by the size of the domain");
    Options options;
    app.add_option("--seconds", options.seconds, "of a run, about")->capture_default_str();
    app.add_option("--steps", options.steps, "of a run, at least")->check(CLI::Range(2u, 64u))->capture_default_str();
    app.add_option("--runs", options.runs, "of which the median counts")->capture_default_str();
    app.add_option("--json", options.json, "where the figures go");
    CLI11_PARSE(app, argc, argv);
    try {
        nlohmann::ordered_json all = nlohmann::ordered_json::array();
        const glift::Device device = glift::Device::open();
        all.push_back(run_on(device, options));
        if (!device.is_host()) all.push_back(run_on(glift::Device::open("host"), options));
        if (!options.json.empty()) std::ofstream(options.json) << all.dump(2) << "\n";
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_moving_band: %s\n", error.what());
        return 1;
    }
    return 0;
}
