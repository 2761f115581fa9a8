// bench_lookups [--runs N] [--seconds S] [--scale N] [--json FILE]: table 6.1 of Lefohn's thesis (2006). Counts the
// instructions of the table's reads, generated and hand-written, with parameters at run time and with parameters fixed
// when the pipeline is made; and times them.
#include "lookup_cases.h"
#include "measure.h"
#include "spy.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>

namespace {

struct Options {
    int runs = 20;
    double seconds = 0;
    std::uint32_t scale = 0;
    std::string json;
};

struct Instructions {
    std::size_t generated, handwritten;
};

Instructions count_of(const glift::Device& spy, const bench::Case& one) {
    one.generated(spy.commands());
    const std::size_t generated = bench::instructions_of(bench::last_shader());
    one.handwritten(spy.commands());
    return {generated, bench::instructions_of(bench::last_shader())};
}

bool run(const Options& options) {
    const glift::Device device = glift::Device::open();
    const bool is_gpu = device.properties().kind == glift::DeviceKind::gpu;
    const double seconds = options.seconds > 0 ? options.seconds : is_gpu ? 0.01 : 0.05;
    const glift::Device spy = bench::spy_on(device);
    const std::vector<bench::Case> counted = bench::make_lookups(spy, 1),
                                   timed = bench::make_lookups(device, options.scale ? options.scale
                                                                       : is_gpu      ? 16
                                                                                     : 1);
    std::printf("%s\n\n| read | specialised | instructions | generated | hand-written | time ratio | same result |\n"
                "| --- | --- | ---: | ---: | ---: | ---: | --- |\n",
                device.properties().name.c_str());
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    bool all_agree = true;
    for (std::size_t i = 0; i < timed.size(); ++i)
        for (const bool special : {false, true}) {
            const auto as = [&](const bench::Case& one) { return special ? bench::specialised(one) : one; };
            const Instructions n = count_of(spy, as(counted[i]));
            const bench::Measured m = bench::measure(device, as(timed[i]), options.runs, seconds);
            std::printf("| %s | %s | %zu / %zu | %.4f ms | %.4f ms | %.3f | %s |\n", timed[i].name.c_str(),
                        special ? "yes" : "no", n.generated, n.handwritten, m.generated * 1e3, m.handwritten * 1e3,
                        m.ratio, m.agree ? "yes" : "NO");
            std::fflush(stdout);
            all_agree = all_agree && m.agree;
            rows.push_back({{"name", timed[i].name},
                            {"specialised", special},
                            {"generated_instructions", n.generated},
                            {"handwritten_instructions", n.handwritten},
                            {"generated_seconds", m.generated},
                            {"handwritten_seconds", m.handwritten},
                            {"ratio", m.ratio},
                            {"agree", m.agree}});
        }
    const nlohmann::ordered_json all = {{"device", device.properties().name}, {"runs", options.runs}, {"reads", rows}};
    if (!options.json.empty()) std::ofstream(options.json) << all.dump(2) << "\n";
    return all_agree;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Instructions and times of reads through address translators, beside those by hand");
    Options options;
    app.add_option("--runs", options.runs, "of which the median counts")->capture_default_str();
    app.add_option("--seconds", options.seconds, "of a run, about; 0: by the kind of device");
    app.add_option("--scale", options.scale, "of the work; 0: by the kind of device");
    app.add_option("--json", options.json, "where the figures go");
    CLI11_PARSE(app, argc, argv);
    try {
        return run(options) ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_lookups: %s\n", error.what());
        return 1;
    }
}
