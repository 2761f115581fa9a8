#include "timing.h"

#include "median.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace bench {

namespace {

double seconds_of(const glift::Device& device, const glift::Recording& recording) {
    const glift::Commands commands = device.commands();
    const glift::Timestamp before = commands.timestamp();
    recording.submit();
    const glift::Timestamp after = commands.timestamp();
    device.wait();
    return after - before;
}

/// A GPU that idled while pipelines were compiled takes a while to raise its clocks again.
void warm_up(const glift::Device& device, const glift::Recording& recording) {
    constexpr std::chrono::milliseconds enough(100);
    const auto start = std::chrono::steady_clock::now();
    do seconds_of(device, recording);
    while (std::chrono::steady_clock::now() - start < enough);
}

}  // namespace

double time_of(const glift::Device& device, const std::function<void(const glift::Commands&)>& work, int runs,
               double seconds) {
    const auto repeated = [&](int times) {
        return device.record([&](const glift::Commands& commands) {
            for (int i = 0; i < times; ++i) work(commands);
        });
    };
    const glift::Recording once = repeated(1);
    seconds_of(device, once);
    warm_up(device, once);
    const double guess = std::max(seconds_of(device, once), 1e-6);
    const int repeats = std::clamp(static_cast<int>(std::ceil(seconds / guess)), 1, 200);
    const glift::Recording recording = repeated(repeats);
    seconds_of(device, recording);
    std::vector<double> times;
    for (int run = 0; run < runs; ++run) times.push_back(seconds_of(device, recording) / repeats);
    return median(times);
}

}  // namespace bench
