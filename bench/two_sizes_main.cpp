// bench_two_sizes [side]: kernels over two arrays of one type, of one size and of two, on the host device and on the
// Vulkan device. Prints the median time of a call; in brackets the time for one size divided by that for two.
#include "timing.h"
#include "two_sizes.glift.hpp"

#include <cstdio>
#include <cstdlib>

namespace {

void compare(const glift::Device& device, const char* what, const bench::Work& one, const bench::Work& two) {
    constexpr int runs = 11;
    constexpr double seconds = 0.02;
    const std::vector<double> times = bench::times_of(device, {one, two}, runs, seconds);
    std::printf("%-8s %-8s one size %8.4f ms  two sizes %8.4f ms (%.3f)\n",
                device.properties().name.substr(0, 8).c_str(), what, 1e3 * times[0], 1e3 * times[1],
                times[0] / times[1]);
}

void measure(const glift::Device& device, glift::uint3 extent) {
    using glift::Commands;
    two_sizes::Volume x(device, extent), y(device, extent), larger(device, extent + glift::uint3(0, 8, 8));
    compare(
        device, "copy", [&](const Commands& c) { two_sizes::copy_one(c, x, y); },
        [&](const Commands& c) { two_sizes::copy_two(c, x, larger); });
    compare(
        device, "axpy", [&](const Commands& c) { two_sizes::axpy_one(c, x, y); },
        [&](const Commands& c) { two_sizes::axpy_two(c, x, larger); });
    compare(
        device, "7-point", [&](const Commands& c) { two_sizes::seven_one(c, x, y); },
        [&](const Commands& c) { two_sizes::seven_two(c, x, larger); });
}

}  // namespace

int main(int argc, char** argv) {
    const auto side = static_cast<glift::uint>(argc > 1 ? std::atoi(argv[1]) : 256);
    for (const glift::Device& device : {glift::Device::open("host"), glift::Device::open()})
        measure(device, {side, side, side});
}
