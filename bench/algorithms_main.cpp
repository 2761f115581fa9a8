// bench_algorithms: times stdlib/algorithms on one device, by its timestamps.
//
//     bench_algorithms [--device NAME] [--log2 20,24] [--systems 256,1024] [--only ALGORITHM] [--runs N] [--seconds S]
//                      [--json FILE]
#include "algorithm_cases.h"
#include "figures.h"
#include "timing.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <string>
#include <vector>

namespace {

struct Options {
    std::string device, only, json;
    std::vector<unsigned> log2 = {20, 24}, systems;
    int runs = 11;
    double seconds = 0.005;
};

void run(const Options& options) {
    const glift::Device device = glift::Device::open(options.device);
    bench::DeviceFigures figures{device.properties().name, {}};
    const auto time_all = [&](const std::vector<bench::AlgorithmCase>& cases) {
        for (const bench::AlgorithmCase& one : cases) {
            if (!options.only.empty() && options.only != one.algorithm) continue;
            const double seconds = bench::time_of(device, one.work, options.runs, options.seconds);
            figures.rows.push_back({"Glift", one.algorithm, one.variant, one.elements, seconds, one.bytes, options.runs,
                                    one.error ? one.error() : -1});
            bench::print(figures.rows.back());
        }
    };
    for (unsigned log2 : options.log2) time_all(bench::algorithm_cases(device, 1u << log2));
    for (unsigned n : options.systems) time_all(bench::tridiagonal_cases(device, n));
    if (!options.json.empty()) bench::write_json(options.json, {figures});
}

}  // namespace

int main(int count, char** arguments) {
    CLI::App app("stdlib/algorithms on one device, by its clock");
    Options options;
    app.add_option("--device", options.device, "host, gpu, lavapipe or a part of a device's name");
    app.add_option("--log2", options.log2, "base-2 logarithms of the numbers of elements")
        ->delimiter(',')
        ->check(CLI::Range(0u, 30u));
    app.add_option("--systems", options.systems, "so many tridiagonal systems of so many unknowns")->delimiter(',');
    app.add_option("--only", options.only, "the name of an algorithm; no others are timed");
    app.add_option("--runs", options.runs, "number of timed runs; the median is reported")->check(CLI::PositiveNumber);
    app.add_option("--seconds", options.seconds, "how long a run takes at least");
    app.add_option("--json", options.json, "file to write the results to");
    CLI11_PARSE(app, count, arguments);
    try {
        run(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_algorithms: %s\n", error.what());
        return 1;
    }
}
