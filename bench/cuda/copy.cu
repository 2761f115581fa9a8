// Memory bandwidth: every element is read once and written once.
#include "rivals.cuh"

namespace rivals {

namespace {

__global__ void copy_elements(const uint4* x, uint4* y, std::size_t count) {
    const std::size_t stride = static_cast<std::size_t>(gridDim.x) * blockDim.x;
    for (std::size_t i = static_cast<std::size_t>(blockIdx.x) * blockDim.x + threadIdx.x; i < count; i += stride) {
        y[i] = x[i];
    }
}

}  // namespace

void copy(Bench& bench) {
    for (std::size_t count : bench.sizes()) {
        const DeviceArray<std::uint32_t> x(count), y(count);
        x.fill(Hashed{});
        const auto memcpy = [&] {
            RIVALS_CUDA(cudaMemcpyAsync(y.data(), x.data(), x.bytes(), cudaMemcpyDeviceToDevice));
        };
        const std::size_t vectors = count / 4;
        const unsigned blocks = static_cast<unsigned>((vectors + 1023) / 1024);  // four vectors per thread
        const auto kernel = [&] {
            copy_elements<<<blocks, 256>>>(reinterpret_cast<const uint4*>(x.data()), reinterpret_cast<uint4*>(y.data()),
                                           vectors);
            RIVALS_CUDA(cudaGetLastError());
        };
        if (bench.checks(count)) {
            for (const Work& run : {Work(memcpy), Work(kernel)}) {
                y.poison();
                run();
                require_equal("copy", y.all(), on_host<std::uint32_t>(count, Hashed{}));
            }
        }
        bench.time("copy", "memcpy", count, 8 * count, memcpy);
        bench.time("copy", "kernel", count, 8 * count, kernel);
    }
}

}  // namespace rivals
