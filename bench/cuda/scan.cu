#include "rivals.cuh"

#include <cub/device/device_scan.cuh>

#include <numeric>

namespace rivals {

void scan(Bench& bench) {
    for (std::size_t count : bench.sizes()) {
        const DeviceArray<std::uint32_t> x(count), y(count);
        x.fill(Hashed{});
        const Work run = with_workspace([&](void* workspace, std::size_t& bytes) {
            return cub::DeviceScan::ExclusiveSum(workspace, bytes, x.data(), y.data(), static_cast<int>(count));
        });
        if (bench.checks(count)) {
            run();
            std::vector<std::uint32_t> expected = on_host<std::uint32_t>(count, Hashed{});
            std::exclusive_scan(expected.begin(), expected.end(), expected.begin(), std::uint32_t{0});
            require_equal("scan", y.all(), expected);
        }
        bench.time("scan", "exclusive_sum_u32", count, 8 * count, run);
    }
}

}  // namespace rivals
