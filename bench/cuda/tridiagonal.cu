// n systems of n unknowns with one right-hand side: cuSPARSE's batched solver without pivoting, one system after the
// other in memory. Several right-hand sides take cuSPARSE one call each, so they are not measured. Beside it, a kernel
// that only moves the bytes of such systems, with one and with three right-hand sides. `elements` are unknowns.
#include "rivals.cuh"

#include <cusparse.h>

#include <algorithm>
#include <cmath>

namespace rivals {

namespace {

/// The coefficients of equation i of n * n: lower * x[i - 1] + diagonal * x[i] + upper * x[i + 1] = right. The matrices
/// are diagonally dominant. Factors are powers of two, so that products are exact and every compiler gets the same
/// bits.
struct Lower {
    std::uint32_t n;
    __host__ __device__ float operator()(std::size_t i) const {
        return i % n == 0 ? 0.0f : -0.125f - 0.25f * unit(static_cast<std::uint32_t>(4 * i));
    }
};
struct Diagonal {
    __host__ __device__ float operator()(std::size_t i) const {
        return 2.0f + unit(static_cast<std::uint32_t>(4 * i + 1));
    }
};
struct Upper {
    std::uint32_t n;
    __host__ __device__ float operator()(std::size_t i) const {
        return i % n == n - 1 ? 0.0f : -0.125f - 0.25f * unit(static_cast<std::uint32_t>(4 * i + 2));
    }
};
struct Right {
    __host__ __device__ float operator()(std::size_t i) const {
        return 2.0f * unit(static_cast<std::uint32_t>(4 * i + 3)) - 1.0f;
    }
};

void require(cusparseStatus_t status) {
    if (status != CUSPARSE_STATUS_SUCCESS) fail(std::string("cuSPARSE: ") + cusparseGetErrorString(status));
}

class Handle {
public:
    Handle() { require(cusparseCreate(&handle_)); }
    ~Handle() { cusparseDestroy(handle_); }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    cusparseHandle_t get() const { return handle_; }

private:
    cusparseHandle_t handle_ = nullptr;
};

/// Solves one system by Thomas' algorithm in double precision.
std::vector<double> solved(std::size_t first, std::uint32_t n) {
    std::vector<double> c(n), x(n);
    for (std::uint32_t k = 0; k < n; ++k) {
        const double lower = Lower{n}(first + k), before_c = k ? c[k - 1] : 0, before_x = k ? x[k - 1] : 0;
        const double pivot = Diagonal{}(first + k) - lower * before_c;
        c[k] = Upper{n}(first + k) / pivot;
        x[k] = (Right{}(first + k) - lower * before_x) / pivot;
    }
    for (std::uint32_t k = n - 1; k-- > 0;) x[k] -= c[k] * x[k + 1];
    return x;
}

/// The largest max |x - exact| / max |exact| of the systems that are checked.
double largest_error(const DeviceArray<float>& x, std::uint32_t n) {
    constexpr std::size_t checked = 16;  // evenly spread, the first and the last among them
    const std::vector<float> found = x.all();
    double largest = 0;
    for (std::size_t system = 0; system < checked; ++system) {
        const std::size_t first = system * (n - 1) / (checked - 1) * n;
        const std::vector<double> exact = solved(first, n);
        double difference = 0, size_of_exact = 0;
        for (std::uint32_t k = 0; k < n; ++k) {
            const double distance = std::abs(found[first + k] - exact[k]);
            difference = distance <= difference ? difference : distance;  // keeps a NaN
            size_of_exact = std::max(size_of_exact, std::abs(exact[k]));
        }
        const double error = difference / size_of_exact;
        largest = error <= largest ? largest : error;
    }
    if (!(largest <= 1e-5)) fail("tridiagonal: wrong solution");
    return largest;
}

void measure(Bench& bench, const Handle& handle, std::uint32_t n) {
    const std::size_t count = std::size_t{n} * n;
    const DeviceArray<float> lower(count), diagonal(count), upper(count), right(count), x(count);
    lower.fill(Lower{n});
    diagonal.fill(Diagonal{});
    upper.fill(Upper{n});
    right.fill(Right{});
    const int size = static_cast<int>(n);
    std::size_t bytes = 0;
    require(cusparseSgtsv2StridedBatch_bufferSizeExt(handle.get(), size, lower.data(), diagonal.data(), upper.data(),
                                                     x.data(), size, size, &bytes));
    const DeviceArray<unsigned char> workspace(bytes);
    const Work refill = [&] {
        RIVALS_CUDA(cudaMemcpyAsync(x.data(), right.data(), right.bytes(), cudaMemcpyDeviceToDevice));
    };
    const Work run = [&] {
        require(cusparseSgtsv2StridedBatch(handle.get(), size, lower.data(), diagonal.data(), upper.data(), x.data(),
                                           size, size, workspace.data()));
    };
    bench.time("tridiagonal", "n_" + std::to_string(n), count, 5 * sizeof(float) * count, run, refill);
    bench.note_error(largest_error(x, n));
}

/// Moves the bytes that a solver has to move at least: for each equation, reads three coefficients and `sides`
/// right-hand sides, and writes `sides` unknowns.
template <int sides> __global__ void move_elements(const float4* from, float4* to, std::size_t count) {
    const std::size_t stride = static_cast<std::size_t>(gridDim.x) * blockDim.x;
    for (std::size_t i = static_cast<std::size_t>(blockIdx.x) * blockDim.x + threadIdx.x; i < count; i += stride) {
        const float4 a = from[i], b = from[count + i], c = from[2 * count + i];
        for (int side = 0; side < sides; ++side) {
            const float4 d = from[(3 + side) * count + i];
            to[side * count + i] = {a.x + b.x + c.x + d.x, a.y + b.y + c.y + d.y, a.z + b.z + c.z + d.z,
                                    a.w + b.w + c.w + d.w};
        }
    }
}

/// Times these moves: of the same elements each time, or, to measure memory, cycling through so many sets that none
/// stays in a cache.
template <int sides> void measure_moving(Bench& bench, std::uint32_t n, const std::string& variant, bool from_memory) {
    constexpr std::size_t beyond_caches = std::size_t{128} << 20;
    const std::size_t count = std::size_t{n} * n, vectors = count / 4, bytes = 5 * sizeof(float) * count;
    const std::size_t sets = from_memory ? std::max<std::size_t>(1, (beyond_caches + bytes - 1) / bytes) : 1;
    const DeviceArray<float> from(sets * (3 + sides) * count), to(sides * count);
    from.fill(Right{});
    const unsigned blocks = static_cast<unsigned>((vectors + 511) / 512);  // two vectors of each array per thread
    std::size_t turn = 0;
    const Work run = [&] {
        const std::size_t set = turn++ % sets;
        move_elements<sides><<<blocks, 256>>>(reinterpret_cast<const float4*>(from.data()) + set * (3 + sides) * vectors,
                                              reinterpret_cast<float4*>(to.data()), vectors);
        RIVALS_CUDA(cudaGetLastError());
    };
    bench.time("move_equations", variant, sides * count, (3 + 2 * sides) * sizeof(float) * count, run);
}

}  // namespace

void tridiagonal(Bench& bench) {
    const Handle handle;
    for (std::uint32_t n : {256u, 512u, 1024u, 2048u, 4096u}) {
        measure(bench, handle, n);
        const std::string one = "n_" + std::to_string(n), three = one + "_three", from_memory = "_from_memory";
        measure_moving<1>(bench, n, one, false);
        measure_moving<3>(bench, n, three, false);
        measure_moving<1>(bench, n, one + from_memory, true);
        measure_moving<3>(bench, n, three + from_memory, true);
    }
}

}  // namespace rivals
