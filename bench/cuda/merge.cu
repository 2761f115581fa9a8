// Merges two sorted halves into one sorted array.
#include "rivals.cuh"

#include <cub/device/device_merge.cuh>

#include <algorithm>
#include <iterator>

namespace rivals {

namespace {

/// An ascending sequence that spreads over all 32-bit numbers.
struct Ascending {
    std::uint32_t gap, seed;
    __host__ __device__ std::uint32_t operator()(std::size_t i) const {
        const auto place = static_cast<std::uint32_t>(i);
        return place * gap + hash32(place ^ seed) % gap;
    }
};

}  // namespace

void merge(Bench& bench) {
    for (std::size_t count : bench.sizes()) {
        const std::size_t half = count / 2;
        const auto gap = static_cast<std::uint32_t>((std::uint64_t{1} << 32) / half);
        const Ascending first_keys{gap, input_seed}, second_keys{gap, ~input_seed};
        const DeviceArray<std::uint32_t> first(half), second(half), y(count);
        first.fill(first_keys);
        second.fill(second_keys);
        const Work run = with_workspace([&first, &second, &y, half](void* workspace, std::size_t& bytes) {
            const auto items = static_cast<std::int64_t>(half);
            return cub::DeviceMerge::MergeKeys(workspace, bytes, first.data(), items, second.data(), items, y.data());
        });
        if (bench.checks(count)) {
            run();
            const std::vector<std::uint32_t> a = on_host<std::uint32_t>(half, first_keys),
                                             b = on_host<std::uint32_t>(half, second_keys);
            std::vector<std::uint32_t> expected;
            std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(expected));
            require_equal("merge", y.all(), expected);
        }
        bench.time("merge", "keys_u32", count, 8 * count, run);
    }
}

}  // namespace rivals
