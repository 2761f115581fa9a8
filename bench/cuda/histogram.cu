// Histograms of 256 bins: by the keys' low byte, extracted while reading, and of keys below 256 (CUB's fastest case).
#include "rivals.cuh"

#include <cub/device/device_histogram.cuh>
#include <thrust/iterator/transform_iterator.h>

namespace rivals {

namespace {

constexpr int bins = 256;

struct LowByte {
    __host__ __device__ std::uint32_t operator()(std::uint32_t key) const { return key & 255u; }
};

struct SmallKeys {
    __host__ __device__ std::uint32_t operator()(std::size_t i) const { return LowByte{}(Hashed{}(i)); }
};

template <class Iterator>
Work histogram_of(Iterator samples, const DeviceArray<std::uint32_t>& counts, std::size_t count) {
    return with_workspace([samples, &counts, count](void* workspace, std::size_t& bytes) {
        return cub::DeviceHistogram::HistogramEven(workspace, bytes, samples, counts.data(), bins + 1, std::uint32_t{0},
                                                   std::uint32_t{bins}, static_cast<int>(count));
    });
}

}  // namespace

void histogram(Bench& bench) {
    for (std::size_t count : bench.sizes()) {
        const DeviceArray<std::uint32_t> keys(count), small_keys(count), counts(bins);
        keys.fill(Hashed{});
        small_keys.fill(SmallKeys{});
        const Work low_byte = histogram_of(thrust::make_transform_iterator(keys.data(), LowByte{}), counts, count);
        const Work below_256 = histogram_of(small_keys.data(), counts, count);
        if (bench.checks(count)) {
            std::vector<std::uint32_t> expected(bins);
            for (std::size_t i = 0; i < count; ++i) ++expected[SmallKeys{}(i)];
            for (const Work& run : {low_byte, below_256}) {
                counts.poison();
                run();
                require_equal("histogram", counts.all(), expected);
            }
        }
        bench.time("histogram", "low_byte", count, 4 * count, low_byte);
        bench.time("histogram", "below_256", count, 4 * count, below_256);
    }
}

}  // namespace rivals
