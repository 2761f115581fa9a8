// bench_components [side]: kernels over two of eight components of an array of structs, kept apart (a struct of arrays)
// and together (an array of structs), beside two arrays of floats alone; dense, and in pages. On the host device and on
// the Vulkan device. Prints the median time of a call; in brackets the time alone divided by it.
#include "components.glift.hpp"
#include "timing.h"

#include <cstdio>
#include <cstdlib>

namespace {

void compare(const glift::Device& device, const char* what, const std::vector<bench::Work>& works) {
    constexpr int runs = 11;
    constexpr double seconds = 0.02;
    const std::vector<double> times = bench::times_of(device, works, runs, seconds);
    std::printf("%-8s %-12s alone %8.3f ms  apart %8.3f ms (%.2f)  together %8.3f ms (%.2f)\n",
                device.properties().name.substr(0, 8).c_str(), what, 1e3 * times[0], 1e3 * times[1],
                times[0] / times[1], 1e3 * times[2], times[0] / times[2]);
}

void measure_dense(const glift::Device& device, glift::uint3 extent) {
    using glift::Commands;
    components::Alone x(device, extent), y(device, extent);
    components::Apart apart(device, extent);
    components::Together together(device, extent);
    compare(device, "axpy",
            {[&](const Commands& c) { components::axpy_alone(c, x, y); },
             [&](const Commands& c) { components::axpy_apart(c, apart); },
             [&](const Commands& c) { components::axpy_together(c, together); }});
    compare(device, "7-point",
            {[&](const Commands& c) { components::seven_alone(c, x, y); },
             [&](const Commands& c) { components::seven_apart(c, apart); },
             [&](const Commands& c) { components::seven_together(c, together); }});
}

void measure_pages(const glift::Device& device, glift::uint3 extent) {
    using glift::Commands;
    const glift::uint pages = extent.x * extent.y * extent.z / 512;
    components::Two two(device, extent, pages);
    components::GridApart apart(device, extent, pages);
    components::GridTogether together(device, extent, pages);
    two.begin(device);
    components::begin_apart(device, apart);
    components::begin_together(device, together);
    compare(device, "axpy pages",
            {[&](const Commands& c) { two.axpy_pages(c); },
             [&](const Commands& c) { components::axpy_pages_apart(c, apart); },
             [&](const Commands& c) { components::axpy_pages_together(c, together); }});
    compare(device, "7-point pages",
            {[&](const Commands& c) { two.seven_pages(c); },
             [&](const Commands& c) { components::seven_pages_apart(c, apart); },
             [&](const Commands& c) { components::seven_pages_together(c, together); }});
}

}  // namespace

int main(int argc, char** argv) {
    const auto side = static_cast<glift::uint>(argc > 1 ? std::atoi(argv[1]) : 256);
    for (const glift::Device& device : {glift::Device::open("host"), glift::Device::open()}) {
        measure_dense(device, {side, side, side});
        measure_pages(device, {side, side, side});
    }
}
