// bench_ranks [--ranks N] [--what diffusion|band] [--side N] [--strong] [--steps N] [--halo N] [--no-overlap] [--cores
// N]
// [--json FILE]: the time of a step on several devices of this host, a process for each (GLIFT_DEVICE=host or lavapipe:
// all use that device).
//
//   diffusion  examples/heat over `side`^3 voxels; unless --strong, so many for each rank (side along x and y)
//   band       examples/narrow_band/moving_shell.glift: topology and two stencils of the pages around a moving shell,
//   in
//              a domain of `side`^3 elements with a shell of 0.39 side; unless --strong, both grow with the square root
//              of the number of ranks, so that each rank has as many pages
//
// Prints for each rank the time of a step, the bytes that it sent in one, and the time of an exchange from when the
// device has packed its elements until the others' have arrived; the device computes meanwhile.
#include "heat.glift.hpp"
#include "moving_shell.glift.hpp"

#include <glift/ranks/processes.h>
#include <glift/ranks/world.h>

#include <sched.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <string>

namespace {

struct Options {
    unsigned ranks = 2;
    std::string what = "band", json;
    std::uint32_t side = 1024, steps = 32, halo = 2;
    int runs = 5;
    unsigned cores = 0;
    bool strong = false, no_overlap = false;
};

struct Figures {
    double step = 0;                                   ///< seconds, the median of the runs
    double exchange = 0;                               ///< seconds of the host in exchanges, a step
    double bytes = 0;                                  ///< that this rank sent in exchanges, a step
    std::uint64_t elements = 0;                        ///< of all ranks
    double imbalance = 1;                              ///< the most pages of a rank over the mean
    double exchanges = 0, distributed = 0, whole = 0;  ///< a step
};

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Runs `steps` steps, then three times as many, `runs` times, after one run that counts for nothing. The difference
/// counts, since pipelines allocate their temporaries once.
template <class Steps> void measure(glift::ranks::World& world, const Options& options, Figures& figures, Steps run) {
    std::vector<double> times;
    const auto seconds_of = [&](std::uint32_t steps) {
        world.device().wait();
        world.barrier();
        const double begin = now();
        run(steps);
        world.device().wait();
        world.barrier();
        return now() - begin;
    };
    for (int k = 0; k <= options.runs; ++k) {
        const double few = seconds_of(options.steps);
        const glift::ranks::Statistics before = world.statistics();
        const double many = seconds_of(3 * options.steps);
        const glift::ranks::Statistics after = world.statistics();
        if (k > 0) times.push_back((many - few) / (2 * options.steps));
        const auto a_step = [&](auto count) { return static_cast<double>(count) / (3 * options.steps); };
        figures.bytes = a_step(after.exchanged_bytes - before.exchanged_bytes);
        figures.exchange = a_step(after.exchange_seconds - before.exchange_seconds);
        figures.exchanges = a_step(after.exchanges - before.exchanges);
        figures.distributed = a_step(after.distributed_passes - before.distributed_passes);
        figures.whole = a_step(after.whole_passes - before.whole_passes);
    }
    std::ranges::sort(times);
    figures.step = times[times.size() / 2];
}

Figures diffusion(glift::ranks::World& world, const Options& options) {
    const std::uint32_t depth = options.strong ? options.side : options.side * options.ranks;
    heat::Volume u(world.device(), {options.side, options.side, depth});
    world.distribute(u, {.halo = options.halo});
    u.fill(1.0f);
    Figures figures;
    figures.elements = std::uint64_t{options.side} * options.side * depth;
    measure(world, options, figures, [&](std::uint32_t steps) { heat::diffuse(world.device(), u, 0.125f, steps); });
    return figures;
}

Figures band_of(glift::ranks::World& world, const Options& options) {
    const double growth = options.strong ? 1 : std::sqrt(options.ranks);
    const auto side = static_cast<std::uint32_t>(std::ceil(options.side * growth / 8) * 8);
    const auto radius = static_cast<float>(0.39 * options.side * growth);
    const float r = radius + 16;
    const auto capacity =
        static_cast<std::uint32_t>(4 * std::numbers::pi_v<float> * r * r * 2 * 9.6f / 512 * 1.1f) + 256;
    band::Band band(world.device(), {side, side, side}, capacity);
    moving_shell::Clock clock(world.device(), 1);
    world.distribute(band, {.halo = options.halo});
    moving_shell::begin(world.device(), band, clock, radius);
    Figures figures;
    figures.imbalance = world.balance(band);
    measure(world, options, figures, [&](std::uint32_t steps) {
        moving_shell::set(world.device(), clock, 0);
        for (std::uint32_t step = 0; step < steps; ++step) moving_shell::step(world.device(), band, clock, radius);
    });
    figures.elements = std::uint64_t{band.pages().state().read()[0].resident} * 512;
    return figures;
}

/// This process uses cores [first, first + count) alone.
void stay_on_cores(unsigned first, unsigned count) {
    cpu_set_t cores;
    CPU_ZERO(&cores);
    for (unsigned k = 0; k < count; ++k) CPU_SET(first + k, &cores);
    if (sched_setaffinity(0, sizeof cores, &cores) != 0) std::fputs("bench_ranks: cannot choose cores\n", stderr);
}

int run(std::shared_ptr<glift::ranks::Transport> transport, const Options& options) {
    const unsigned rank = transport->rank();
    if (options.cores != 0) stay_on_cores(rank * options.cores, options.cores);
    const glift::Device device = glift::ranks::device_of(*transport);
    glift::ranks::World world(std::move(transport), device, {.overlaps = !options.no_overlap});
    const Figures f = options.what == "band" ? band_of(world, options) : diffusion(world, options);
    std::printf(
        "%s, %s, %u ranks, halo %u, %s, rank %u on %s: %.1f us a step, %.0f bytes sent in %.2f exchanges of %.1f us, "
        "%.1f M elements, imbalance %.3f; %.0f passes distributed, %.0f whole\n",
        options.what.c_str(), options.strong ? "strong" : "weak", options.ranks, options.halo,
        options.no_overlap ? "not overlapped" : "overlapped", rank, world.local_device().properties().name.c_str(),
        1e6 * f.step, f.bytes, f.exchanges, f.exchanges > 0 ? 1e6 * f.exchange / f.exchanges : 0,
        1e-6 * static_cast<double>(f.elements), f.imbalance, f.distributed, f.whole);
    if (rank == 0 && !options.json.empty())
        std::ofstream(options.json) << nlohmann::ordered_json{{"what", options.what},
                                                              {"strong", options.strong},
                                                              {"ranks", options.ranks},
                                                              {"halo", options.halo},
                                                              {"overlaps", !options.no_overlap},
                                                              {"device", world.local_device().properties().name},
                                                              {"elements", f.elements},
                                                              {"step_seconds", f.step},
                                                              {"exchange_seconds", f.exchange},
                                                              {"bytes", f.bytes},
                                                              {"exchanges", f.exchanges},
                                                              {"distributed", f.distributed},
                                                              {"imbalance", f.imbalance}}
                                           .dump(2)
                                    << "\n";
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("The time of a step on several devices of this host");
    Options options;
    app.add_option("--ranks", options.ranks, "processes, of which each has a device")->capture_default_str();
    app.add_option("--what", options.what, "diffusion or band")->check(CLI::IsMember({"diffusion", "band"}));
    app.add_option("--side", options.side, "of the domain")->capture_default_str();
    app.add_option("--steps", options.steps, "of the shorter run; the longer one has three times as many")
        ->capture_default_str();
    app.add_option("--runs", options.runs, "of which the median counts")->capture_default_str();
    app.add_option("--halo", options.halo, "elements that an exchange brings: Distribution::halo")
        ->capture_default_str();
    app.add_flag("--strong", options.strong, "the same domain for any number of ranks");
    app.add_flag("--no-overlap", options.no_overlap, "compute nothing while elements are on their way");
    app.add_option("--cores", options.cores,
                   "on the host device: so many of the processor's cores for each rank; 0: all");
    app.add_option("--json", options.json, "where the figures go");
    CLI11_PARSE(app, argc, argv);
    try {
        return glift::ranks::run_processes(
            options.ranks, [&](std::shared_ptr<glift::ranks::Transport> transport) { return run(transport, options); });
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_ranks: %s\n", error.what());
        return 1;
    }
}
