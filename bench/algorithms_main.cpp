// bench_algorithms: stdlib/algorithms on one device, by its clock.
//
//     bench_algorithms [--device NAME] [--log2 20,24] [--only ALGORITHM] [--json FILE]
//
// A run is a recording that does the same thing so often that submitting it does not show. What a run destroys is made
// again within the recording; the time of that alone is taken off.
#include "algorithms.glift.hpp"
#include "median.h"
#include "solvers.glift.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace {

using Work = std::function<void(const glift::Commands&)>;

struct Case {
    std::string algorithm, variant;
    std::uint64_t elements = 0, bytes = 0;  ///< bytes: the least that must be moved
    Work work, refill;                      ///< refill may be empty
};

double seconds_of(const glift::Device& device, const glift::Recording& recording) {
    const glift::Commands commands = device.commands();
    const glift::Timestamp before = commands.timestamp();
    recording.submit();
    const glift::Timestamp after = commands.timestamp();
    device.wait();
    return after - before;
}

glift::Recording repeated(const glift::Device& device, const Work& work, const Work& refill, int repeats) {
    return device.record([&](const glift::Commands& commands) {
        for (int i = 0; i < repeats; ++i) {
            if (refill) refill(commands);
            if (work) work(commands);
        }
    });
}

/// Median seconds of one execution.
double measure(const glift::Device& device, const Work& work, const Work& refill, int runs, double seconds) {
    const glift::Recording once = repeated(device, work, refill, 1);
    seconds_of(device, once);
    const double guess = std::max(seconds_of(device, once), 1e-6);
    const int repeats = std::clamp(static_cast<int>(std::ceil(seconds / guess)), 1, 200);
    const glift::Recording recording = repeated(device, work, refill, repeats);
    seconds_of(device, recording);
    std::vector<double> times;
    for (int run = 0; run < runs; ++run) times.push_back(seconds_of(device, recording) / repeats);
    return bench::median(times);
}

/// Every algorithm over n elements.
std::vector<Case> cases(const glift::Device& device, std::uint32_t n) {
    const algorithms::Keys y(device, n);
    std::vector<Case> all;
    const auto add = [&](const char* algorithm, const std::string& variant, std::uint64_t bytes, const auto& pipeline,
                         const algorithms::Keys& x) {
        all.push_back(
            {algorithm, variant, n, bytes * n, [=](const glift::Commands& commands) { pipeline(commands, x, y); }, {}});
    };
    const auto input = [&](std::uint32_t run) {
        algorithms::Keys x(device, n);
        algorithms::make_input(device, run, x);
        return x;
    };
    const algorithms::Keys x = input(1);
    algorithms::Keys bytes(device, n);
    algorithms::keep_low_byte(device, x, bytes);
    add("copy", "kernel", 8, algorithms::copy_keys, x);
    add("scan", "exclusive_sum_u32", 8, algorithms::scan, x);
    add("reduce", "sum_u32", 4, algorithms::reduce_sum, x);
    add("select", "if_1_in_8", 4, algorithms::select_if, x);
    for (std::uint32_t run : {1u, 8u, 256u})
        add("unique", "runs_" + std::to_string(run), 4, algorithms::select_unique, input(run));
    add("histogram", "below_256", 4, algorithms::count_bytes, bytes);
    add("radix_sort", "keys_u32", 8, algorithms::sort_keys, x);
    const algorithms::Keys values = input(1), values_to(device, n);
    all.push_back(
        {"radix_sort",
         "pairs_u32",
         n,
         std::uint64_t{16} * n,
         [=](const glift::Commands& commands) { algorithms::sort_with_values(commands, x, values, y, values_to); },
         {}});
    return all;
}

/// n systems of n unknowns.
std::vector<Case> systems(const glift::Device& device, std::uint32_t n) {
    const glift::uint2 size(n, n);
    solvers::Grid lower(device, size), middle(device, size), upper(device, size), right(device, size), x(device, size);
    solvers::Grid3 right3(device, size), x3(device, size);
    solvers::make_systems(device, n, lower, middle, upper, right);
    solvers::make_right(device, n, right3);
    const std::uint64_t count = std::uint64_t{n} * n;
    const std::string variant = "n_" + std::to_string(n);
    return {{"tridiagonal",
             variant,
             count,
             20 * count,
             [=](const glift::Commands& commands) { solvers::solve(commands, lower, middle, upper, right, x); },
             {}},
            {"tridiagonal",
             variant + "_three",
             3 * count,
             36 * count,
             [=](const glift::Commands& commands) { solvers::solve_three(commands, lower, middle, upper, right3, x3); },
             {}}};
}

}  // namespace

int main(int count, char** arguments) {
    CLI::App app("stdlib/algorithms on one device, by its clock");
    std::string name, only, json_file;
    std::vector<unsigned> log2 = {20, 24}, sides;
    int runs = 11;
    double seconds = 0.005;
    app.add_option("--device", name, "as Device::open takes it");
    app.add_option("--log2", log2, "sizes")->delimiter(',');
    app.add_option("--systems", sides, "so many tridiagonal systems of so many unknowns")->delimiter(',');
    app.add_option("--only", only, "one algorithm");
    app.add_option("--runs", runs, "of which the median is taken");
    app.add_option("--seconds", seconds, "of a run");
    app.add_option("--json", json_file, "where the figures go");
    CLI11_PARSE(app, count, arguments);
    try {
        const glift::Device device = glift::Device::open(name);
        nlohmann::ordered_json rows = nlohmann::ordered_json::array();
        const auto time_all = [&](const std::vector<Case>& all) {
            for (const Case& one : all) {
                if (!only.empty() && only != one.algorithm) continue;
                double time = measure(device, one.work, one.refill, runs, seconds);
                if (one.refill) time -= measure(device, {}, one.refill, runs, seconds);
                std::fprintf(stderr, "%-12s %-18s %10llu %12.2f us %9.2f G elements/s %8.0f GB/s\n",
                             one.algorithm.c_str(), one.variant.c_str(), static_cast<unsigned long long>(one.elements),
                             time * 1e6, static_cast<double>(one.elements) / time * 1e-9,
                             static_cast<double>(one.bytes) / time * 1e-9);
                rows.push_back({{"algorithm", one.algorithm},
                                {"variant", one.variant},
                                {"elements", one.elements},
                                {"seconds", time},
                                {"bytes_moved", one.bytes},
                                {"runs", runs}});
            }
        };
        for (unsigned exponent : log2) time_all(cases(device, 1u << exponent));
        for (unsigned n : sides) time_all(systems(device, n));
        if (!json_file.empty()) std::ofstream(json_file) << rows.dump(1) << "\n";
    } catch (const glift::Error& error) {
        std::fprintf(stderr, "bench_algorithms: %s\n", error.what());
        return 1;
    }
}
