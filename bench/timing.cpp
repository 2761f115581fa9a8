#include "timing.h"

#include "median.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace bench {

double seconds_of(const glift::Device& device, const glift::Recording& recording) {
    const glift::Commands commands = device.commands();
    const glift::Timestamp before = commands.timestamp();
    recording.submit();
    const glift::Timestamp after = commands.timestamp();
    device.wait();
    return after - before;
}

namespace {

/// A GPU that idled while pipelines were compiled takes a while to raise its clocks again.
void warm_up(const glift::Device& device, const glift::Recording& recording) {
    constexpr std::chrono::milliseconds enough(100);
    const auto start = std::chrono::steady_clock::now();
    do seconds_of(device, recording);
    while (std::chrono::steady_clock::now() - start < enough);
}

/// A recording that repeats a work for about `seconds`, but at most 200 times.
struct Repeated {
    glift::Recording recording;
    int times = 1;
};

Repeated repeated(const glift::Device& device, const Work& work, double seconds) {
    const auto recorded = [&](int times) {
        return device.record([&](const glift::Commands& commands) {
            for (int i = 0; i < times; ++i) work(commands);
        });
    };
    const glift::Recording once = recorded(1);
    seconds_of(device, once);
    warm_up(device, once);
    const double guess = std::max(seconds_of(device, once), 1e-6);
    const int times = std::clamp(static_cast<int>(std::ceil(seconds / guess)), 1, 200);
    Repeated made{recorded(times), times};
    seconds_of(device, made.recording);
    return made;
}

}  // namespace

std::vector<double> times_of(const glift::Device& device, const std::vector<Work>& works, int runs, double seconds) {
    std::vector<Repeated> all;
    for (const Work& work : works) all.push_back(repeated(device, work, seconds));
    std::vector<std::vector<double>> times(works.size());
    for (int run = 0; run < runs; ++run)
        for (std::size_t i = 0; i < all.size(); ++i)
            times[i].push_back(seconds_of(device, all[i].recording) / all[i].times);
    std::vector<double> medians;
    for (const std::vector<double>& of_one : times) medians.push_back(median(of_one));
    return medians;
}

double time_of(const glift::Device& device, const Work& work, int runs, double seconds) {
    return times_of(device, {work}, runs, seconds)[0];
}

}  // namespace bench
