// glift_bench: generated shaders against hand-written ones (docs/internals/measurements.md).
//
//     glift_bench [--device NAME] [--runs N] [--seconds S] [--scale N] [--only CASE] [--json FILE]
#include "instructions.h"
#include "report.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace {

struct Options {
    std::string device, json, only;
    int runs = 20;
    double seconds = 0;       ///< of the generated pass in one run; 0: chosen by the kind of device
    std::uint32_t scale = 0;  ///< of the work (cases.h); 0: chosen by the kind of device
};

[[noreturn]] void usage() {
    std::fprintf(
        stderr,
        "usage: glift_bench [--device NAME] [--runs N] [--seconds S] [--scale N] [--only CASE] [--json FILE]\n");
    std::exit(2);
}

Options parse(int count, char** arguments) {
    Options options;
    for (int i = 1; i + 1 < count; i += 2) {
        const std::string name = arguments[i], value = arguments[i + 1];
        if (name == "--device") options.device = value;
        else if (name == "--json") options.json = value;
        else if (name == "--only") options.only = value;
        else if (name == "--runs") options.runs = std::max(1, std::atoi(value.c_str()));
        else if (name == "--seconds") options.seconds = std::atof(value.c_str());
        else if (name == "--scale") options.scale = static_cast<std::uint32_t>(std::atoi(value.c_str()));
        else usage();
    }
    if (count % 2 == 0) usage();
    return options;
}

int run(const Options& options) {
    const glift::Device device = glift::Device::open(options.device);
    const bool is_gpu = device.properties().kind == glift::DeviceKind::gpu;
    const std::uint32_t scale = options.scale ? options.scale : is_gpu ? 16 : 1;
    const double seconds = options.seconds > 0 ? options.seconds : is_gpu ? 0.01 : 0.05;
    std::vector<bench::Row> rows;
    bool all_agree = true;
    for (const bench::Case& one : bench::make_cases(device, scale)) {
        if (!options.only.empty() && one.name != options.only) continue;
        bench::Measured measured = bench::measure(device, one, options.runs, seconds);
        rows.push_back({one.name, one.elements, measured, bench::instructions_of(one.generated_spirv),
                        bench::instructions_of(one.handwritten_spirv)});
        all_agree = all_agree && measured.agree;
    }
    bench::print_table(device.properties().name, rows);
    if (!options.json.empty()) std::ofstream(options.json) << bench::json_of(device.properties(), options.runs, rows);
    return all_agree ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
    const Options options = parse(count, arguments);
    try {
        return run(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
