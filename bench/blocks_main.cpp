// bench_blocks [side]: kernels over a dense array, over the same array in pages visited page by page, and over pages
// visited like a dense array; on the host device and on the Vulkan device. Prints the median time of a kernel call, in
// a recording of many calls ("among many") and in a recording of one ("alone"); in brackets the dense array's time
// divided by it.
#include "timing.h"

#include "blocks.glift.hpp"

#include <cstdio>
#include <cstdlib>

namespace {

/// Times the three works in turn: repeated in recordings of about `seconds`, and each alone in a recording.
void compare(const glift::Device& device, const char* what, const bench::Work& dense, const bench::Work& blocks,
             const bench::Work& whole) {
    constexpr int runs = 11;
    constexpr double seconds = 0.02;
    for (const auto& [how, length] : {std::pair{"among many", seconds}, {"alone", 0.0}}) {
        const std::vector<double> times = bench::times_of(device, {dense, blocks, whole}, runs, length);
        std::printf("%-8s %-4s %-10s  dense %8.3f ms  blocks %8.3f ms (%.2f)  whole range %8.3f ms (%.2f)\n",
                    device.properties().name.substr(0, 8).c_str(), what, how, 1e3 * times[0], 1e3 * times[1],
                    times[0] / times[1], 1e3 * times[2], times[0] / times[2]);
    }
}

void measure(const glift::Device& device, glift::uint side) {
    const glift::uint3 extent(side, side, side);
    const glift::uint pages = (side / 8) * (side / 8) * (side / 8);
    blocks::Dense f(device, extent), g(device, extent);
    blocks::Numbers table(device, pages), active(device, pages), state(device, 1);
    blocks::Listed listed(device, table, active, state, extent, pages),
        listed_to(device, table, active, state, extent, pages);
    blocks::Whole whole(device, table, extent, pages), whole_to(device, table, extent, pages);
    blocks::list_all(device, table, active, state, pages);
    const auto call = [](auto kernel, auto& from, auto& to) {
        return [=, &from, &to](const glift::Commands& commands) { kernel(commands, from, to); };
    };
    compare(device, "each", call(blocks::scale_dense, f, g), call(blocks::scale_blocks, listed, listed_to),
            call(blocks::scale_whole, whole, whole_to));
    compare(device, "near", call(blocks::seven_dense, f, g), call(blocks::seven_blocks, listed, listed_to),
            call(blocks::seven_whole, whole, whole_to));
}

}  // namespace

int main(int argc, char** argv) {
    const auto side = static_cast<glift::uint>(argc > 1 ? std::atoi(argv[1]) : 256);
    measure(glift::Device::open("host"), side);
    measure(glift::Device::open(), side);
}
