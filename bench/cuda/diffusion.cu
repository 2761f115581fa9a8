// The solves alone of depth of field in two layers (examples/depth_of_field): all rows, then all columns, by cuSPARSE's
// batched tridiagonal solvers without pivoting. A picture has seven planes (red, green and blue of two layers, and the
// weight that the background spreads); each row of the picture is stored as seven rows of numbers, one per plane. So
// rows have the layout of cusparseSgtsv2StridedBatch and columns that of cusparseSgtsvInterleavedBatch, and nothing is
// transposed. Both solvers are timed for both directions; the coefficients are computed before. `elements` of a result
// are pixels.
#include "rivals.cuh"

#include <cusparse.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace rivals {

namespace {

constexpr std::size_t planes = 7;

void require(cusparseStatus_t status) {
    if (status != CUSPARSE_STATUS_SUCCESS) fail(std::string("cuSPARSE: ") + cusparseGetErrorString(status));
}

/// How `systems` systems of n equations are laid out: one system after the other, or interleaved (equation by
/// equation). `i` is an index into the stored numbers.
struct Place {
    std::uint32_t n;
    std::size_t systems;
    bool interleaved;

    __host__ __device__ std::size_t equation(std::size_t i) const { return interleaved ? i / systems : i % n; }
    __host__ __device__ std::size_t index(std::size_t system, std::size_t equation) const {
        return interleaved ? equation * systems + system : system * n + equation;
    }
};

/// The coefficient of the unknown before or after: minus the conductivity for circles of confusion of 20 pixels,
/// 20^2 / 32 (`conductivity` of examples/depth_of_field/dof.glift); zero at the ends.
struct Off {
    Place place;
    bool after;
    __host__ __device__ float operator()(std::size_t i) const {
        return place.equation(i) == (after ? place.n - 1 : 0) ? 0.0f : -12.5f;
    }
};
struct Diagonal {
    Place place;
    __host__ __device__ float operator()(std::size_t i) const {
        return 1.0f - Off{place, false}(i)-Off{place, true}(i);
    }
};
struct Right {
    __host__ __device__ float operator()(std::size_t i) const { return unit(static_cast<std::uint32_t>(i)); }
};

/// Checks the residuals of the first, the middle and the last system.
void check(const std::vector<float>& x, const Place& place, const std::string& what) {
    for (const std::size_t system : {std::size_t{0}, place.systems / 2, place.systems - 1}) {
        for (std::size_t k = 0; k < place.n; ++k) {
            const std::size_t i = place.index(system, k);
            double sum = Diagonal{place}(i) * double{x[i]} - Right{}(i);
            if (k > 0) sum += Off{place, false}(i) * double{x[place.index(system, k - 1)]};
            if (k + 1 < place.n) sum += Off{place, true}(i) * double{x[place.index(system, k + 1)]};
            if (!(std::abs(sum) <= 1e-3)) fail(what + ": wrong solution");
        }
    }
}

struct Systems {
    Place place;
    DeviceArray<float> lower, diagonal, upper, x;

    explicit Systems(const Place& place)
        : place(place), lower(count()), diagonal(count()), upper(count()), x(count()) {}
    std::size_t count() const { return place.systems * place.n; }
    void fill() const {
        lower.fill(Off{place, false});
        diagonal.fill(Diagonal{place});
        upper.fill(Off{place, true});
        x.fill(Right{});
    }
    std::size_t bytes() const { return 5 * sizeof(float) * count(); }
};

struct Picture {
    std::uint32_t width, height;
    std::string name() const { return std::to_string(width) + "x" + std::to_string(height); }
    Place rows(bool interleaved) const { return {width, planes * height, interleaved}; }
    Place columns(bool interleaved) const { return {height, planes * width, interleaved}; }
    std::uint64_t pixels() const { return std::uint64_t{width} * height; }
};

using Solve = std::function<void()>;

void measure(Bench& bench, const Picture& picture, const Systems& systems, const std::string& what,
             const Solve& solve) {
    // Solvers may write over the coefficients.
    const Work refill = [&] { systems.fill(); };
    refill();
    solve();
    check(systems.x.all(), systems.place, what);
    bench.time(what, picture.name(), picture.pixels(), systems.bytes(), solve, refill);
}

void strided(Bench& bench, cusparseHandle_t handle, const Picture& picture, const Place& place,
             const std::string& what) {
    const Systems s(place);
    const int n = static_cast<int>(place.n), count = static_cast<int>(place.systems);
    std::size_t bytes = 0;
    require(cusparseSgtsv2StridedBatch_bufferSizeExt(handle, n, s.lower.data(), s.diagonal.data(), s.upper.data(),
                                                     s.x.data(), count, n, &bytes));
    const DeviceArray<unsigned char> workspace(bytes);
    measure(bench, picture, s, what, [&] {
        require(cusparseSgtsv2StridedBatch(handle, n, s.lower.data(), s.diagonal.data(), s.upper.data(), s.x.data(),
                                           count, n, workspace.data()));
    });
}

void interleaved(Bench& bench, cusparseHandle_t handle, const Picture& picture, const Place& place,
                 const std::string& what) {
    constexpr int thomas = 0;
    const Systems s(place);
    const int n = static_cast<int>(place.n), count = static_cast<int>(place.systems);
    std::size_t bytes = 0;
    require(cusparseSgtsvInterleavedBatch_bufferSizeExt(handle, thomas, n, s.lower.data(), s.diagonal.data(),
                                                        s.upper.data(), s.x.data(), count, &bytes));
    const DeviceArray<unsigned char> workspace(bytes);
    measure(bench, picture, s, what, [&] {
        require(cusparseSgtsvInterleavedBatch(handle, thomas, n, s.lower.data(), s.diagonal.data(), s.upper.data(),
                                              s.x.data(), count, workspace.data()));
    });
}

}  // namespace

void diffusion(Bench& bench) {
    cusparseHandle_t handle = nullptr;
    require(cusparseCreate(&handle));
    const Picture pictures[] = {{256, 256}, {512, 512}, {1024, 1024}, {1920, 1080}, {2048, 2048}, {4096, 4096}};
    for (const Picture& picture : pictures) {
        strided(bench, handle, picture, picture.rows(false), "rows_strided");
        interleaved(bench, handle, picture, picture.rows(true), "rows_interleaved");
        strided(bench, handle, picture, picture.columns(false), "columns_strided");
        interleaved(bench, handle, picture, picture.columns(true), "columns_interleaved");
    }
    cusparseDestroy(handle);
}

}  // namespace rivals
