// Sorts in ascending order, out of place, so that a run does not change its input.
#include "rivals.cuh"

#include <cub/device/device_radix_sort.cuh>

#include <algorithm>
#include <numeric>

namespace rivals {

namespace {

struct Positions {
    __host__ __device__ std::uint32_t operator()(std::size_t i) const { return static_cast<std::uint32_t>(i); }
};

struct LongKeys {
    __host__ __device__ std::uint64_t operator()(std::size_t i) const {
        return std::uint64_t{Hashed{}(2 * i)} << 32 | Hashed{}(2 * i + 1);
    }
};

template <class Key, class Make> void sort_keys(Bench& bench, const char* variant, std::size_t count, Make make) {
    const DeviceArray<Key> x(count), y(count);
    x.fill(make);
    const Work run = with_workspace([&x, &y, count](void* workspace, std::size_t& bytes) {
        return cub::DeviceRadixSort::SortKeys(workspace, bytes, static_cast<const Key*>(x.data()), y.data(),
                                              static_cast<int>(count));
    });
    if (bench.checks(count)) {
        run();
        std::vector<Key> expected = on_host<Key>(count, make);
        std::sort(expected.begin(), expected.end());
        require_equal(std::string("sort of ") + variant, y.all(), expected);
    }
    bench.time("radix_sort", variant, count, 2 * sizeof(Key) * count, run);
}

void require_sorted_pairs(const DeviceArray<std::uint32_t>& keys, const DeviceArray<std::uint32_t>& values,
                          std::size_t count, Hashed input) {
    std::vector<std::uint32_t> order = on_host<std::uint32_t>(count, Positions{});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t one, std::uint32_t other) { return input(one) < input(other); });
    require_equal("sort of pairs: values", values.all(), order);
    for (std::uint32_t& one : order) one = input(one);
    require_equal("sort of pairs: keys", keys.all(), order);
}

void sort_pairs(Bench& bench, std::size_t count) {
    const DeviceArray<std::uint32_t> keys(count), values(count), sorted_keys(count), sorted_values(count);
    const auto sort = [&keys, &values, &sorted_keys, &sorted_values, count](void* workspace, std::size_t& bytes) {
        const std::uint32_t *from = keys.data(), *values_from = values.data();
        return cub::DeviceRadixSort::SortPairs(workspace, bytes, from, sorted_keys.data(), values_from,
                                               sorted_values.data(), static_cast<int>(count));
    };
    values.fill(Positions{});
    const Work run = with_workspace(sort);
    if (bench.checks(count)) {
        for (std::uint32_t run_length : {8u, 1u}) {  // runs of 8 equal keys check that the sort is stable
            keys.fill(Hashed{run_length});
            run();
            require_sorted_pairs(sorted_keys, sorted_values, count, Hashed{run_length});
        }
    }
    keys.fill(Hashed{});
    bench.time("radix_sort", "pairs_u32", count, 16 * count, run);
}

}  // namespace

void radix_sort(Bench& bench) {
    for (std::size_t count : bench.sizes()) {
        sort_keys<std::uint32_t>(bench, "keys_u32", count, Hashed{});
        sort_pairs(bench, count);
        sort_keys<std::uint64_t>(bench, "keys_u64", count, LongKeys{});
    }
}

}  // namespace rivals
