// Kernels whose elements run a loop in lockstep: each round for a run of elements of a row.
#pragma once

#include <glift/host/parallel.h>

namespace glift::host {

/// The most elements of a run: a few vectors of the widest kind, whose values stay in the first cache.
inline constexpr uint run_elements = 64;

/// Consecutive elements of a row, from x = `begin` on.
struct Run {
    uint begin;
    uint count;

    Run(uint first, uint end) : begin(first), count(detail::least(run_elements, end - first)) {}
    /// The run that follows; empty at `end`.
    void next(uint end) { *this = Run(begin + count, end); }
    /// Ends the run before the first element for which `value` < `limit` is not as for the run's first element. `value`
    /// is that of the first element, and grows by one with each.
    void cut(uint value, uint limit) {
        if (limit == 0) return;
        const uint next = value < limit ? limit : 0u;  // the value for which that is so: after 2^32 - 1 it is zero
        count = detail::least(count, next - value);
    }
};

/// A value for each element of a run. A vector has an array for each component.
template <class T> struct Kept {
    alignas(64) T values[run_elements];

    T at(std::size_t i) const { return values[i]; }
    void set(std::size_t i, const T& value) { values[i] = value; }
};
template <class T, unsigned N> struct Kept<vec<T, N>> {
    alignas(64) T values[N][run_elements];

    vec<T, N> at(std::size_t i) const {
        vec<T, N> value;
        for (unsigned part = 0; part < N; ++part) value[part] = values[part][i];
        return value;
    }
    void set(std::size_t i, const vec<T, N>& value) {
        for (unsigned part = 0; part < N; ++part) values[part][i] = value[part];
    }
};

/// Memory for copies of one element, in place of the elements of a run.
template <class T> struct Copies {
    alignas(alignof(T) > 64 ? alignof(T) : 64) std::byte bytes[run_elements * sizeof(T)];

    /// `row` if the condition holds, else as many copies of `*one`.
    const T* unless(bool condition, const T* row, const T* one) {
        if (condition) return row;
        for (uint i = 0; i < run_elements; ++i) std::memcpy(bytes + i * sizeof(T), one, sizeof(T));
        return reinterpret_cast<const T*>(bytes);
    }
};

/// for_rows or, in more than one dimension, for_tiles, for elements that are much work: a task may be one run. In
/// tiles, the rows that are computed one after the other load the same elements, if what they load depends on x alone.
template <class Body> void for_runs(const HostSize& size, const Body& body) {
    constexpr std::size_t rows_of_task = 16;
    const std::size_t all_rows = std::size_t{size[1]} * size[2] * size[3], before = size.rows_before();
    if (all_rows <= before) return;
    const std::size_t rows = all_rows - before;
    if (all_rows <= 1) return for_rows(size, body, run_elements);
    const std::size_t runs = (std::size_t{size[0]} + run_elements - 1) / run_elements;
    const std::size_t bands = (rows + rows_of_task - 1) / rows_of_task;
    detail::spread(runs * bands, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t x = i % runs * run_elements, done = i / runs * rows_of_task, first = before + done;
            const Row row{static_cast<uint>(x),
                          static_cast<uint>(detail::least<std::size_t>(x + run_elements, size[0])),
                          static_cast<uint>(first % size[1]), static_cast<uint>(first / size[1] % size[2]),
                          static_cast<uint>(first / size[1] / size[2])};
            body(Rows(row, detail::least(rows_of_task, rows - done), size));
        }
    });
}

}  // namespace glift::host
