// Shared by the .cu files of this folder, which time the rivals with which Glift's algorithms are compared (CUB,
// cuSPARSE, and kernels that only move data): device memory, input, timing, rows of results.
//
// Times are device times: CUDA events around one run, the median of many. Before each run a kernel occupies the stream
// for about 100 microseconds, longer than the host takes to launch any run, so that launch latency is hidden; before
// that kernel comes `refill`, which restores input that a run overwrites and is not timed. All runs of a result use the
// same memories (but for the results `_from_memory` of tridiagonal.cu), so that data that fits into the caches is read
// from there, as in the benches of Glift.
#pragma once

#include <cuda_runtime.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace rivals {

/// Ends the program if a call of CUDA failed.
void require(cudaError_t error, const char* call, const char* file, int line);
#define RIVALS_CUDA(call) ::rivals::require((call), #call, __FILE__, __LINE__)

/// Ends the program with an error: results must be correct to be compared.
[[noreturn]] void fail(const std::string& what);

/// A pseudo-random bijection of 32-bit numbers, the same as in bench/bench_input.h and bench/algorithms.glift.
__host__ __device__ inline std::uint32_t hash32(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

constexpr std::uint32_t input_seed = 0x9e3779b9u;

/// A pseudo-random float in [0, 1) with 24 bits.
__host__ __device__ inline float unit(std::uint32_t x) {
    return static_cast<float>(hash32(x ^ input_seed) >> 8) * (1.0f / 16777216.0f);
}

/// Element i of the input: runs of equal elements, each of `run_length`; neighbouring runs differ.
struct Hashed {
    std::uint32_t run_length = 1;
    __host__ __device__ std::uint32_t operator()(std::size_t i) const {
        return hash32(static_cast<std::uint32_t>(i / run_length) ^ input_seed);
    }
};

/// Memory of the device.
template <class T> class DeviceArray {
public:
    explicit DeviceArray(std::size_t size) : size_(size) {
        void* address = nullptr;
        RIVALS_CUDA(cudaMalloc(&address, size ? size * sizeof(T) : 1));
        data_ = static_cast<T*>(address);
        poison();
    }
    ~DeviceArray() { cudaFree(data_); }
    DeviceArray(const DeviceArray&) = delete;
    DeviceArray& operator=(const DeviceArray&) = delete;

    T* data() const { return data_; }
    std::size_t bytes() const { return size_ * sizeof(T); }

    /// Fills the memory with a pattern, so that a check finds elements that a run did not write.
    void poison() const { RIVALS_CUDA(cudaMemset(data_, 0xa5, bytes())); }

    std::vector<T> first(std::size_t count) const {
        std::vector<T> values(count);
        RIVALS_CUDA(cudaMemcpy(values.data(), data_, count * sizeof(T), cudaMemcpyDeviceToHost));
        return values;
    }
    T front() const { return first(1)[0]; }
    std::vector<T> all() const { return first(size_); }

    /// Sets element i to make(i), for all i.
    template <class Make> void fill(Make make) const;

private:
    T* data_ = nullptr;
    std::size_t size_;
};

template <class T, class Make> __global__ void fill_elements(T* x, std::size_t count, Make make) {
    const std::size_t stride = static_cast<std::size_t>(gridDim.x) * blockDim.x;
    for (std::size_t i = static_cast<std::size_t>(blockIdx.x) * blockDim.x + threadIdx.x; i < count; i += stride) {
        x[i] = static_cast<T>(make(i));
    }
}

template <class T> template <class Make> void DeviceArray<T>::fill(Make make) const {
    fill_elements<<<2048, 256>>>(data_, size_, make);
    RIVALS_CUDA(cudaGetLastError());
    RIVALS_CUDA(cudaDeviceSynchronize());
}

/// The elements that DeviceArray::fill makes, on the host.
template <class T, class Make> std::vector<T> on_host(std::size_t count, Make make) {
    std::vector<T> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<T>(make(i));
    return values;
}

template <class T>
void require_equal(const std::string& what, const std::vector<T>& found, const std::vector<T>& expected) {
    if (found.size() != expected.size()) fail(what + ": wrong number of elements");
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i] != expected[i]) fail(what + ": element " + std::to_string(i) + " is wrong");
    }
}

using Work = std::function<void()>;

/// Makes work of a function of CUB: call(workspace, bytes) sets `bytes` to the size of the workspace that it needs if
/// `workspace` is null, else runs.
template <class Call> Work with_workspace(Call call) {
    std::size_t bytes = 0;
    RIVALS_CUDA(call(static_cast<void*>(nullptr), bytes));
    const auto workspace = std::make_shared<DeviceArray<unsigned char>>(bytes);
    return [=] {
        std::size_t size = bytes;
        RIVALS_CUDA(call(static_cast<void*>(workspace->data()), size));
    };
}

struct Row {
    std::string algorithm, variant;
    std::uint64_t elements;
    double seconds;             ///< median
    std::uint64_t bytes_moved;  ///< the least: input read once, output written once (left out if it is a few numbers)
    int runs;
    double error = -1;  ///< largest relative error of the results; negative: not measured
};

/// The sizes and the number of runs that were asked for, and the results. All work is put into the default stream.
class Bench {
public:
    Bench(std::vector<std::size_t> sizes, int runs) : sizes_(std::move(sizes)), runs_(runs) {}

    const std::vector<std::size_t>& sizes() const { return sizes_; }
    bool checks(std::size_t size) const { return size == sizes_.front(); }  ///< true for the smallest size alone

    /// Adds a row and prints it to stderr.
    void time(
        const std::string& algorithm, const std::string& variant, std::uint64_t elements, std::uint64_t bytes_moved,
        const Work& run, const Work& refill = [] {});

    /// Sets the error of the row that was added last.
    void note_error(double error);

    const std::vector<Row>& rows() const { return rows_; }

private:
    std::vector<std::size_t> sizes_;  ///< ascending
    int runs_;
    std::vector<Row> rows_;
};

// The families: each function times an algorithm, or a few related ones, in all variants.
void copy(Bench& bench);
void scan(Bench& bench);
void reduce(Bench& bench);
void select(Bench& bench);
void unique(Bench& bench);
void radix_sort(Bench& bench);
void histogram(Bench& bench);
void merge(Bench& bench);
void tridiagonal(Bench& bench);
void diffusion(Bench& bench);

}  // namespace rivals
