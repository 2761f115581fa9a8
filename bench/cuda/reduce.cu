#include "rivals.cuh"

#include <cub/device/device_reduce.cuh>

#include <cmath>
#include <numeric>

namespace rivals {

namespace {

struct Units {
    __host__ __device__ float operator()(std::size_t i) const { return unit(static_cast<std::uint32_t>(i)); }
};

template <class T> Work sum_of(const DeviceArray<T>& x, const DeviceArray<T>& total, std::size_t count) {
    return with_workspace([&x, &total, count](void* workspace, std::size_t& bytes) {
        return cub::DeviceReduce::Sum(workspace, bytes, x.data(), total.data(), static_cast<int>(count));
    });
}

void reduce_words(Bench& bench, std::size_t count) {
    const DeviceArray<std::uint32_t> x(count), total(1);
    x.fill(Hashed{});
    const Work run = sum_of(x, total, count);
    if (bench.checks(count)) {
        run();
        const std::vector<std::uint32_t> values = on_host<std::uint32_t>(count, Hashed{});
        const std::uint32_t expected = std::accumulate(values.begin(), values.end(), std::uint32_t{0});
        if (total.front() != expected) fail("reduce of u32: wrong sum");
    }
    bench.time("reduce", "sum_u32", count, 4 * count, run);
}

void reduce_floats(Bench& bench, std::size_t count) {
    const DeviceArray<float> x(count), total(1);
    x.fill(Units{});
    const Work run = sum_of(x, total, count);
    if (bench.checks(count)) {
        run();
        const std::vector<float> values = on_host<float>(count, Units{});
        const double expected = std::accumulate(values.begin(), values.end(), 0.0);
        if (!(std::abs(total.front() - expected) <= 1e-5 * expected)) fail("reduce of f32: wrong sum");
    }
    bench.time("reduce", "sum_f32", count, 4 * count, run);
}

}  // namespace

void reduce(Bench& bench) {
    for (std::size_t count : bench.sizes()) {
        reduce_words(bench, count);
        reduce_floats(bench, count);
    }
}

}  // namespace rivals
