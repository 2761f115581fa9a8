// How host kernels spread over the cores: blocks of rows, and atomic combination of values.
#pragma once

#include <glift/pass.h>
#include <glift/vector.h>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstddef>

// Compiled once for each width of vectors; the dynamic linker takes the widest that this machine has.
#if !defined(GLIFT_HOST_KERNEL)
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__linux__) && defined(__OPTIMIZE__) &&        \
    !defined(__AVX2__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define GLIFT_HOST_KERNEL __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define GLIFT_HOST_KERNEL
#endif
#endif

// Before a loop whose rounds are independent.
#if defined(__clang__)
#define GLIFT_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define GLIFT_INDEPENDENT _Pragma("GCC ivdep")
#else
#define GLIFT_INDEPENDENT
#endif

namespace glift::host {

/// Elements [begin, end) along x of the row at y, z, w.
struct Row {
    uint begin, end;
    uint y, z, w;
};

namespace detail {

/// Work for one task: enough to pay for starting it, little enough to share evenly.
inline constexpr std::size_t task_elements = 1 << 14;

}  // namespace detail

/// Calls `body(const Row&)` for rows that together cover `size` once. Rows run in parallel, neighbours mostly in turn.
template <class Body>
void for_each_row(const std::array<std::uint32_t, 4>& size, const Body& body) {
    const std::size_t rows = std::size_t{size[1]} * size[2] * size[3];
    if (rows == 0 || size[0] == 0) return;
    const std::size_t all = rows * size[0];
    if (rows == 1 || size[0] > 16 * detail::task_elements) {  // long rows: split them
        const std::size_t pieces = (size[0] + detail::task_elements - 1) / detail::task_elements;
        const auto piece = [&](std::size_t i) {
            const std::size_t row = i / pieces, begin = i % pieces * detail::task_elements;
            const std::size_t end = std::min<std::size_t>(begin + detail::task_elements, size[0]);
            body(Row{static_cast<uint>(begin), static_cast<uint>(end), static_cast<uint>(row % size[1]),
                     static_cast<uint>(row / size[1] % size[2]), static_cast<uint>(row / size[1] / size[2])});
        };
        tbb::parallel_for(std::size_t{0}, rows * pieces, piece);
        return;
    }
    const auto run = [&](std::size_t first, std::size_t last) {
        uint y = static_cast<uint>(first % size[1]), z = static_cast<uint>(first / size[1] % size[2]),
             w = static_cast<uint>(first / size[1] / size[2]);
        for (std::size_t row = first; row < last; ++row) {
            body(Row{0, size[0], y, z, w});
            if (++y == size[1]) {
                y = 0;
                if (++z == size[2]) z = 0, ++w;
            }
        }
    };
    if (all <= detail::task_elements) return run(0, rows);
    const std::size_t grain = std::max<std::size_t>(1, detail::task_elements / size[0]);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rows, grain),
                      [&](const tbb::blocked_range<std::size_t>& range) { run(range.begin(), range.end()); });
}

/// Calls `body(group id, group count)` for the workgroups that cover `size`, in parallel.
template <class Body>
void for_each_group(const std::array<std::uint32_t, 4>& size, uint3 group, const Body& body) {
    const uint3 count((size[0] + group.x - 1) / group.x, (size[1] + group.y - 1) / group.y, (size[2] * size[3] + group.z - 1) / group.z);
    const std::size_t total = std::size_t{count.x} * count.y * count.z;
    const auto run = [&](std::size_t i) {
        body(uint3(static_cast<uint>(i % count.x), static_cast<uint>(i / count.x % count.y), static_cast<uint>(i / count.x / count.y)), count);
    };
    if (total == 1) run(0);
    else tbb::parallel_for(std::size_t{0}, total, run);
}

/// The elements of a buffer.
template <class T>
T* elements(const HostMemory& memory) {
    return reinterpret_cast<T*>(memory.data);
}

/// Elements [begin, end) of a row along x.
struct Part {
    uint begin, end;
};

/// The part of a row's [begin, end) that is at least `radius` away from every side of `domain`. `first` is the address
/// of the range's first element; axes that the range does not have are 1 long in `domain` and not looked at.
template <unsigned N>
Part interior_of(const Row& row, const vec<uint, N>& first, const vec<uint, N>& domain, uint radius) {
    const auto inside = [radius](uint a, uint n) { return a >= radius && n > radius && a < n - radius; };
    bool rest = inside(first.y + row.y, domain.y);
    if constexpr (N > 2) rest = rest && inside(first.z + row.z, domain.z);
    if constexpr (N > 3) rest = rest && inside(first.w + row.w, domain.w);
    if (!rest || domain.x <= radius) return {row.end, row.end};
    const uint low = radius > first.x ? radius - first.x : 0;
    const uint past = domain.x - radius;
    const uint high = past > first.x ? past - first.x : 0;
    const uint begin = std::clamp(low, row.begin, row.end);
    return {begin, std::clamp(high, begin, row.end)};
}
inline Part interior_of(const Row& row, uint first, uint domain, uint radius) {
    const Row flat{row.begin, row.end, 0, 0, 0};
    return interior_of(flat, uint2{first, radius}, uint2{domain, 2 * radius + 1}, radius);
}

/// What of `part` keeps a value within [low, high] that is `value` at element `first` and advances by one.
inline Part unclamped(const Part& part, uint first, std::int32_t value, std::int32_t low, std::int32_t high) {
    const std::int64_t begin = std::int64_t{first} + low - value, end = std::int64_t{first} + high - value + 1;
    const std::int64_t from = std::clamp<std::int64_t>(begin, part.begin, part.end);
    return {static_cast<uint>(from), static_cast<uint>(std::clamp<std::int64_t>(end, from, part.end))};
}

// ---------------------------------------------------------------------------------- scatter: combine with what is there

template <class T>
void atomic_replace(T& target, T value) {
    std::atomic_ref<T>(target).store(value, std::memory_order_relaxed);
}

template <class T, class Combine>
T atomic_update(T& target, const Combine& combine) {
    std::atomic_ref<T> shared(target);
    T old = shared.load(std::memory_order_relaxed);
    while (!shared.compare_exchange_weak(old, combine(old), std::memory_order_relaxed)) {}
    return old;
}
template <class T>
void atomic_min(T& target, T value) {
    std::atomic_ref<T> shared(target);
    T old = shared.load(std::memory_order_relaxed);
    while (value < old && !shared.compare_exchange_weak(old, value, std::memory_order_relaxed)) {}
}
template <class T>
void atomic_max(T& target, T value) {
    std::atomic_ref<T> shared(target);
    T old = shared.load(std::memory_order_relaxed);
    while (old < value && !shared.compare_exchange_weak(old, value, std::memory_order_relaxed)) {}
}
template <class T>
void atomic_add(T& target, T value) {
    std::atomic_ref<T>(target).fetch_add(value, std::memory_order_relaxed);
}
template <class T>
void atomic_bit_and(T& target, T value) {
    std::atomic_ref<T>(target).fetch_and(value, std::memory_order_relaxed);
}
template <class T>
void atomic_bit_or(T& target, T value) {
    std::atomic_ref<T>(target).fetch_or(value, std::memory_order_relaxed);
}
template <class T>
void atomic_bit_xor(T& target, T value) {
    std::atomic_ref<T>(target).fetch_xor(value, std::memory_order_relaxed);
}

// Atomics on workgroup memory. A workgroup runs on one thread, one invocation after the other.
template <class T>
T atomicAdd(T& target, T value) { return std::exchange(target, glift::detail::add(target, value)); }
template <class T>
T atomicMin(T& target, T value) { return std::exchange(target, value < target ? value : target); }
template <class T>
T atomicMax(T& target, T value) { return std::exchange(target, target < value ? value : target); }
template <class T>
T atomicAnd(T& target, T value) { return std::exchange(target, static_cast<T>(target & value)); }
template <class T>
T atomicOr(T& target, T value) { return std::exchange(target, static_cast<T>(target | value)); }
template <class T>
T atomicXor(T& target, T value) { return std::exchange(target, static_cast<T>(target ^ value)); }
template <class T>
T atomicExchange(T& target, T value) { return std::exchange(target, value); }

}  // namespace glift::host
