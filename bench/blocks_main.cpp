// bench_blocks [side]: kernels over a dense array, over the same array in pages visited page by page, and over pages
// visited like a dense array; on the host device and on the Vulkan device. Prints the least time of a kernel among
// many, called one after the other, and the ratio to dense; and that of a kernel alone, with a submission and a wait of
// its own.
#include "blocks.glift.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

/// The seconds that one of `calls` calls takes, of which the last is waited for.
template <class Run> double seconds(const glift::Device& device, int calls, const Run& run) {
    const auto begin = std::chrono::steady_clock::now();
    for (int call = 0; call < calls; ++call) run();
    device.wait();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / calls;
}

/// Times the three alternately and prints the least time of each.
template <class Dense, class Blocks, class Whole> void compare(const glift::Device& device, const char* what, int calls,
                                                               const Dense& dense, const Blocks& blocks,
                                                               const Whole& whole) {
    constexpr int rounds = 7;
    double least[3] = {1e9, 1e9, 1e9};
    for (int round = 0; round < rounds; ++round) {
        least[0] = std::min(least[0], seconds(device, calls, dense));
        least[1] = std::min(least[1], seconds(device, calls, blocks));
        least[2] = std::min(least[2], seconds(device, calls, whole));
    }
    std::printf("%-8s %-6s %3d calls  dense %8.3f ms  blocks %8.3f ms (%.2f)  whole range %8.3f ms (%.2f)\n",
                device.properties().name.substr(0, 8).c_str(), what, calls, 1e3 * least[0], 1e3 * least[1],
                least[0] / least[1], 1e3 * least[2], least[0] / least[2]);
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
    const bool is_gpu = device.properties().kind == glift::DeviceKind::gpu;
    for (const int calls : {is_gpu ? 50 : 2, 1}) {
        compare(
            device, "each", calls, [&] { blocks::scale_dense(device, f, g); },
            [&] { blocks::scale_blocks(device, listed, listed_to); },
            [&] { blocks::scale_whole(device, whole, whole_to); });
        compare(
            device, "near", calls, [&] { blocks::seven_dense(device, f, g); },
            [&] { blocks::seven_blocks(device, listed, listed_to); },
            [&] { blocks::seven_whole(device, whole, whole_to); });
    }
}

}  // namespace

int main(int argc, char** argv) {
    const auto side = static_cast<glift::uint>(argc > 1 ? std::atoi(argv[1]) : 256);
    measure(glift::Device::open("host"), side);
    measure(glift::Device::open(), side);
}
