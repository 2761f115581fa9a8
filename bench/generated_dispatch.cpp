// Measures the host's time per dispatch where generated functions make the dispatches: by calls of kernels, when a
// pipeline is recorded, and when the recording is replayed.
#include "dispatch.glift.hpp"

#include <benchmark/benchmark.h>

namespace {

// Fewer than the 512 operations after which the device submits its open batch, so that the timed part submits nothing.
constexpr int kernel_passes = 500;
constexpr glift::uint pipeline_passes = 1000;

void per_pass(benchmark::State& state, int passes) {
    state.counters["s/pass"] =
        benchmark::Counter(passes, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

struct Lines {
    glift::Device device = glift::Device::open();
    dispatch::Line f{device, 64}, g{device, 64};
};

struct Volumes {
    glift::Device device = glift::Device::open();
    dispatch::Volume u{device, {4, 4, 4}}, v{device, {4, 4, 4}};
};

void record_line_kernels(const glift::Commands& commands, const Lines& lines) {
    for (int k = 0; k < kernel_passes / 2; ++k) {
        dispatch::scale(commands, lines.f, lines.g, 2.0f);
        dispatch::scale(commands, lines.g, lines.f, 0.5f);
    }
}

void record_volume_kernels(const glift::Commands& commands, const Volumes& volumes) {
    for (int k = 0; k < kernel_passes / 2; ++k) {
        dispatch::smooth(commands, volumes.u, volumes.v, 0.125f);
        dispatch::smooth(commands, volumes.v, volumes.u, 0.125f);
    }
}

/// Records kernel calls into the device's own stream; the time until the device has run them is not counted.
template <class Structures, void (*record)(const glift::Commands&, const Structures&)>
void generated_kernel(benchmark::State& state) {
    const Structures structures;
    record(structures.device, structures);
    structures.device.wait();
    for (auto _ : state) {
        record(structures.device, structures);
        state.PauseTiming();
        structures.device.wait();
        state.ResumeTiming();
    }
    per_pass(state, kernel_passes);
}
BENCHMARK(generated_kernel<Lines, record_line_kernels>)
    ->Name("generated_each_1d")
    ->Unit(benchmark::kMicrosecond)
    ->Iterations(30);
BENCHMARK(generated_kernel<Volumes, record_volume_kernels>)
    ->Name("generated_near_3d")
    ->Unit(benchmark::kMicrosecond)
    ->Iterations(30);

void record_pipeline(benchmark::State& state) {
    Lines lines;
    dispatch::chain(lines.device, lines.f, lines.g, 2);
    for (auto _ : state) {
        benchmark::DoNotOptimize(lines.device.record(
            [&](const glift::Commands& commands) { dispatch::chain(commands, lines.f, lines.g, pipeline_passes); }));
    }
    per_pass(state, pipeline_passes);
}
BENCHMARK(record_pipeline)->Name("generated_pipeline_record")->Unit(benchmark::kMicrosecond);

/// Submits a recording of all passes, and counts the submissions of a replay, which should be one.
void replay_pipeline(benchmark::State& state) {
    Lines lines;
    const auto recording = lines.device.record(
        [&](const glift::Commands& commands) { dispatch::chain(commands, lines.f, lines.g, pipeline_passes); });
    lines.device.wait();
    const auto before = lines.device.statistics().submissions;
    for (auto _ : state) {
        recording.submit();
        state.PauseTiming();
        lines.device.wait();
        state.ResumeTiming();
    }
    state.counters["submissions"] = benchmark::Counter(
        static_cast<double>(lines.device.statistics().submissions - before), benchmark::Counter::kAvgIterations);
    per_pass(state, pipeline_passes);
}
BENCHMARK(replay_pipeline)->Name("generated_pipeline_replay")->Unit(benchmark::kMicrosecond)->Iterations(30);

}  // namespace
