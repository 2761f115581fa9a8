#include "measure.h"

#include "median.h"

#include <algorithm>
#include <cmath>

namespace bench {

namespace {

using Pass = std::function<void(const glift::Commands&)>;

/// Seconds of one pass, the mean of `repeats`, by device timestamps. A first pass is not counted: the caches may still
/// hold the other pass's data.
double time_of(const glift::Device& device, const Pass& pass, int repeats) {
    glift::Commands commands = device.commands();
    pass(commands);
    glift::Timestamp before = commands.timestamp();
    for (int i = 0; i < repeats; ++i) pass(commands);
    glift::Timestamp after = commands.timestamp();
    commands.wait();
    return (after - before) / repeats;
}

}  // namespace

Measured measure(const glift::Device& device, const Case& one, int runs, double seconds) {
    Measured measured;
    one.clear();
    one.handwritten(device.commands());
    std::vector<std::byte> expected = one.result();
    one.clear();
    one.generated(device.commands());
    measured.agree = one.result() == expected;
    time_of(device, one.handwritten, 2);
    const double once = std::max(time_of(device, one.generated, 2), 1e-7);
    const int repeats = std::clamp(static_cast<int>(std::ceil(seconds / once)), 1, 400);
    std::vector<double> generated, handwritten, ratios;
    for (int run = 0; run < runs; ++run) {
        double first = time_of(device, run % 2 ? one.generated : one.handwritten, repeats);
        double second = time_of(device, run % 2 ? one.handwritten : one.generated, repeats);
        generated.push_back(run % 2 ? first : second);
        handwritten.push_back(run % 2 ? second : first);
        ratios.push_back(generated.back() / handwritten.back());
    }
    measured.generated = median(generated);
    measured.handwritten = median(handwritten);
    measured.ratio = median(ratios);
    return measured;
}

}  // namespace bench
