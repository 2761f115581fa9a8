// bench_shadows [--scenes A,B] [--frames N] [--size N] [--runs N] [--cases A,B] [--json FILE], and more (--help):
// section 11.4.3 of Lefohn's thesis (2006) again. Times frames of examples/shadows along its recorded paths, by
// resolution-matched and adaptive shadow maps (RMSM, ASM) and a standard map, of scenes that move and that stand still;
// counts pages and, of scenes that move, the texels of these pages that are looked up; and, on a Vulkan device, times
// each pass.
#include "median.h"
#include "shadow_cases.h"
#include "shadow_lookups.h"

#include "examples/shadows/walk.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>

namespace {

struct Options {
    Walk walk;
    std::vector<std::string> cases;
    std::uint32_t side = 1024, static_frames = 30;
    unsigned runs = 3;
    std::string json;
};

double percentile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

/// In how many frames there were coarser pages or none in place of those asked for. ASM asks round by round, and may
/// evict pages of one round in the next: for ASM, a full pool counts as one that is too small.
std::size_t frames_short_of_pages(const bench::ShadowCase& one, const bench::ShadowFrames& found) {
    std::size_t frames = 0;
    for (std::size_t i = 0; i < found.pages.size(); ++i) {
        const bool is_full = one.method == Method::adaptive && found.pages[i] == found.capacity;
        frames += is_full || found.coarsened[i] > 0 || found.refused[i] > 0 ? 1 : 0;
    }
    return frames;
}

nlohmann::ordered_json row_of(const std::string& scene, const bench::ShadowCase& one,
                              const bench::ShadowFrames& found) {
    nlohmann::ordered_json passes = nlohmann::ordered_json::array();
    for (const bench::PassTime& pass : found.passes) passes.push_back({{"name", pass.name}, {"seconds", pass.seconds}});
    nlohmann::ordered_json row = {{"scene", scene},
                                  {"case", one.name},
                                  {"is_static", one.is_static},
                                  {"cells", one.settings.cells},
                                  {"levels", one.settings.levels},
                                  {"frames", found.seconds.size()},
                                  {"seconds", found.seconds},
                                  {"median", bench::median(found.seconds)},
                                  {"percentile_95", percentile(found.seconds, 0.95)},
                                  {"pages", found.pages},
                                  {"granted", found.granted},
                                  {"refused", found.refused},
                                  {"asked", found.asked},
                                  {"coarsened", found.coarsened},
                                  {"rounds", found.rounds},
                                  {"pool_too_small", frames_short_of_pages(one, found)},
                                  {"page_bytes", 4 * found.texels_a_page},
                                  {"capacity", found.capacity},
                                  {"pool_bytes", 4 * found.texels_a_page * found.capacity},
                                  {"submissions", found.submissions},
                                  {"waits", found.waits},
                                  {"passes", passes}};
    if (found.touched) row["touched"] = *found.touched;
    return row;
}

/// Marks a row whose frames did not get the pages they asked for, since its times are not those of what was asked.
std::string note_on(const nlohmann::ordered_json& row) {
    const auto frames = row["pool_too_small"].get<std::size_t>();
    if (frames == 0) return "";
    return "POOL TOO SMALL in " + std::to_string(frames) + " of " + std::to_string(row["pages"].size()) + " frames";
}

void print_head(const Options& options, const std::string& device) {
    std::printf(
        "%s, %u x %u; times: median and 95th percentile over frames, each the median of %u runs; pages: median "
        "and most; pool of %u pages of 32 x 32 cells\n\n"
        "| scene | case | frames | median | 95th percentile | asked | pages | rounds | pool, MB | texels looked "
        "up | note |\n| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | --- |\n",
        device.c_str(), options.side, options.side, options.runs, options.walk.settings.pages);
}

void print(const nlohmann::ordered_json& row) {
    const auto text = [&](const char* key) { return row[key].get<std::string>(); };
    const auto spread = [&](const char* key) {
        const auto values = row[key].get<std::vector<double>>();
        std::printf(" %.0f, %.0f |", bench::median(values), *std::max_element(values.begin(), values.end()));
    };
    std::printf("| %s | %s | %zu | %.3f ms | %.3f ms |", text("scene").c_str(), text("case").c_str(),
                row["frames"].get<std::size_t>(), 1e3 * row["median"].get<double>(),
                1e3 * row["percentile_95"].get<double>());
    for (const char* key : {"asked", "pages", "rounds"}) spread(key);
    std::printf(" %.1f |", 1e-6 * row["pool_bytes"].get<double>());
    if (row.contains("touched")) std::printf(" %.1f %% |", 100 * row["touched"].get<double>());
    else std::printf(" |");
    std::printf(" %s |\n", note_on(row).c_str());
    std::fflush(stdout);
}

void write(const Options& options, const nlohmann::ordered_json& all) {
    if (options.json.empty()) return;
    std::ofstream out(options.json);
    out << all.dump(1) << "\n";
    if (!out.flush()) throw std::runtime_error(options.json + ": cannot be written");
}

std::vector<bench::ShadowCase> chosen(const Options& options) {
    const std::vector<bench::ShadowCase> all = bench::shadow_cases(options.walk.settings);
    if (options.cases.empty()) return all;
    std::vector<bench::ShadowCase> some;
    for (const std::string& name : options.cases) {
        const auto found = std::ranges::find(all, name, &bench::ShadowCase::name);
        if (found == all.end()) {
            std::string known;
            for (const bench::ShadowCase& one : all) known += (known.empty() ? "" : ", ") + one.name;
            throw std::runtime_error("there is no case '" + name + "'; there are " + known);
        }
        some.push_back(*found);
    }
    return some;
}

nlohmann::ordered_json lookups_of(const std::string& scene, const bench::LookupTimes& found) {
    return {{"scene", scene},
            {"nearest_seconds", found.nearest},
            {"gather_seconds", found.gather},
            {"compare_seconds", found.compare},
            {"lit_by_gather", found.lit_by_gather},
            {"lit_by_compare", found.lit_by_compare}};
}

/// Times, prints and adds lookups of a standard map alone. Does nothing on the host device, whose passes are not timed.
void add_lookups(const glift::Device& device, const Options& options, const std::string& scene,
                 const std::vector<scenes::Scene>& moving, nlohmann::ordered_json& all) {
    if (device.is_host()) return;
    const bench::LookupTimes found =
        bench::lookup_times(device, options.walk.settings, moving, {options.side, options.side});
    std::printf("| %s | lookups of a plain map alone | %zu | | | | | | | | nearest %.4f ms, gathered %.4f ms, by the "
                "hardware's comparison %.4f ms; lit %.3f and %.3f |\n",
                scene.c_str(), moving.size(), 1e3 * found.nearest, 1e3 * found.gather, 1e3 * found.compare,
                found.lit_by_gather, found.lit_by_compare);
    all["lookups"].push_back(lookups_of(scene, found));
    write(options, all);
}

void run(const Options& options) {
    const std::vector<bench::ShadowCase> cases = chosen(options);
    const glift::Device device = glift::Device::open();
    nlohmann::ordered_json all = {{"device", device.properties().name},
                                  {"side", options.side},
                                  {"standard_side", options.walk.settings.standard},
                                  {"runs", options.runs},
                                  {"pages", options.walk.settings.pages},
                                  {"rows", nlohmann::ordered_json::array()},
                                  {"lookups", nlohmann::ordered_json::array()}};
    print_head(options, device.properties().name);
    for (const std::string& scene : options.walk.scenes) {
        const std::vector<scenes::Scene> moving = bench::scenes_along(scene, options.walk.steps_of(scene));
        Walk from_the_first = options.walk;
        from_the_first.only_first = true, from_the_first.frames = options.static_frames;
        const std::vector<scenes::Scene> still = bench::scenes_along(scene, from_the_first.steps_of(scene));
        for (const bench::ShadowCase& one : cases) {
            const bench::ShadowFrames found =
                bench::measure(device, one, one.is_static ? still : moving, {options.side, options.side}, options.runs);
            all["rows"].push_back(row_of(scene, one, found));
            print(all["rows"].back());
            write(options, all);  // after each row: an interrupted run leaves those it has measured
        }
        if (std::ranges::find(cases, "standard", &bench::ShadowCase::name) != cases.end())
            add_lookups(device, options, scene, moving, all);
    }
    for (const std::string& message : device.validation_messages()) throw std::runtime_error(message);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Frames of examples/shadows: times, pages, and times of passes");
    Options options;
    options.walk.frames = 30;             // all of a recorded path
    options.walk.settings.pages = 16384;  // at 1024 x 1024 frames of the hairball ask for up to 12,000
    app.add_option("--scenes", options.walk.scenes, "of the example's, with commas between them")->delimiter(',');
    app.add_option("--cases", options.cases, "only these, with commas between them")->delimiter(',');
    app.add_option("--frames", options.walk.frames, "of each path, spread evenly")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--static-frames", options.static_frames,
                   "of each path, one after the other, where pages stay from one to the next")
        ->check(CLI::Range(2, 1000))
        ->capture_default_str();
    app.add_option("--paths", options.walk.paths, "the folder of the recorded paths")->capture_default_str();
    app.add_option("--size", options.side, "of the pictures, pixels a side")
        ->check(CLI::Range(16, 8192))
        ->capture_default_str();
    app.add_option("--levels", options.walk.settings.levels, "of a map, with pages of 32 cells a side")
        ->check(CLI::Range(8, 13))
        ->capture_default_str();
    app.add_option("--pages", options.walk.settings.pages, "that the pool has room for")
        ->check(CLI::Range(64, 65536))
        ->capture_default_str();
    app.add_option("--pairs", options.walk.settings.pairs, "of a triangle and a page that there is room for")
        ->check(CLI::Range(1u, 50'000'000u))
        ->capture_default_str();
    app.add_option("--standard", options.walk.settings.standard, "texels a side")
        ->check(CLI::Range(16, 16384))
        ->capture_default_str();
    app.add_option("--runs", options.runs, "of which a frame's median is taken")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--json", options.json, "where the figures go");
    CLI11_PARSE(app, argc, argv);
    try {
        run(options);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_shadows: %s\n", error.what());
        return 1;
    }
}
