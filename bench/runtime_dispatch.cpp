// Measures the host's time per dispatch: recorded into the device's own stream, recorded into a recording, and when a
// recording is submitted again. The goal is at most 2 microseconds to record; nothing here checks it.
#include <glift/glift.h>

#include "runtime_dispatch.h"

#include <benchmark/benchmark.h>

namespace {

const glift::Binding bindings[] = {
    {.name = "f.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::read},
    {.name = "g.data", .kind = glift::MemoryKind::buffer, .access = glift::Access::write}};

const glift::Kernel kernel = {.name = "scale",
                              .file = "runtime_dispatch.cpp",
                              .line = 1,
                              .rank = 1,
                              .group = {64, 1, 1},
                              .loop_rounds = 0,
                              .bindings = bindings,
                              .direct = {.spirv = runtime_dispatch, .parameter_bytes = 8, .push_constants = true},
                              .digest = 1};

struct Parameters {
    std::uint32_t size;
    float factor;
};

// Fewer than the 512 operations after which the device submits its open batch (`most_operations` in
// immediate_stream.cpp), so that the timed part submits nothing.
constexpr int passes = 500;

// Each pass reads what the previous one wrote and so needs a barrier, which is the expensive case.
void record_chain(const glift::Commands& commands, const glift::Memory (&memories)[3]) {
    for (int k = 0; k < passes; ++k) {
        const Parameters block = {64, 1.0f};
        commands.dispatch(kernel, {.form = glift::FormName::direct,
                                   .memories = {memories + k % 2, 2},
                                   .parameters = std::as_bytes(std::span(&block, 1)),
                                   .size = {64, 1, 1, 1}});
    }
}

struct Setup {
    glift::Device device = glift::Device::open();
    glift::Memory memories[3];

    Setup() {
        // Two memories in the order f, g, f: `memories + k % 2` are f and g, or g and f.
        memories[0] = device.allocate({.name = "f.data", .bytes = 256});
        memories[1] = device.allocate({.name = "g.data", .bytes = 256});
        memories[2] = memories[0];
        record_chain(device, memories);
        device.wait();
    }
};

void per_pass(benchmark::State& state) {
    state.counters["s/pass"] =
        benchmark::Counter(passes, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void record_passes(benchmark::State& state) {
    const Setup setup;
    for (auto _ : state) {
        record_chain(setup.device, setup.memories);
        state.PauseTiming();
        setup.device.wait();
        state.ResumeTiming();
    }
    per_pass(state);
}
BENCHMARK(record_passes)->Unit(benchmark::kMicrosecond)->Iterations(30);

void record_a_recording(benchmark::State& state) {
    const Setup setup;
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            setup.device.record([&](const glift::Commands& commands) { record_chain(commands, setup.memories); }));
    }
    per_pass(state);
}
BENCHMARK(record_a_recording)->Unit(benchmark::kMicrosecond);

void submit_a_recording(benchmark::State& state) {
    const Setup setup;
    const auto recording =
        setup.device.record([&](const glift::Commands& commands) { record_chain(commands, setup.memories); });
    for (auto _ : state) {
        recording.submit();
        state.PauseTiming();
        setup.device.wait();
        state.ResumeTiming();
    }
    per_pass(state);
}
BENCHMARK(submit_a_recording)->Unit(benchmark::kMicrosecond)->Iterations(30);

}  // namespace
