// Hand-written C++ versions of stdlib/algorithms with oneTBB: rivals on the host device. All run on all cores.
// Functions with loops that sum or count have a second form, `narrow`, in which these are compiled without function
// multiversioning: vectors only as wide as the compiler's flags allow.
#pragma once

#include <cstdint>
#include <span>

namespace host_rivals {

struct KeyValue {
    std::uint32_t key, value;
};

/// Exclusive scan by tbb::parallel_scan: y[i] = x[0] + .. + x[i - 1], modulo 2^32. Returns the sum of all elements.
std::uint32_t exclusive_scan(std::span<const std::uint32_t> x, std::span<std::uint32_t> y);
std::uint32_t exclusive_scan_narrow(std::span<const std::uint32_t> x, std::span<std::uint32_t> y);

/// The sum by tbb::parallel_reduce.
std::uint32_t sum(std::span<const std::uint32_t> x);
std::uint32_t sum_narrow(std::span<const std::uint32_t> x);

/// The sum by tbb::parallel_deterministic_reduce: the same bits every time.
float sum(std::span<const float> x);
float sum_narrow(std::span<const float> x);

/// Copies the multiples of 8 of x, in order, to y, which has room for all of x. Returns their number. Two passes over
/// blocks: the first counts, the second writes.
std::size_t copy_multiples_of_8(std::span<const std::uint32_t> x, std::span<std::uint32_t> y);
std::size_t copy_multiples_of_8_narrow(std::span<const std::uint32_t> x, std::span<std::uint32_t> y);

/// Sorts by tbb::parallel_sort: ascending, not stable.
void sort(std::span<std::uint32_t> keys);
void sort(std::span<KeyValue> pairs);

}  // namespace host_rivals
