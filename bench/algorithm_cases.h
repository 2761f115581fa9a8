// The work that bench_algorithms times: algorithms of the standard library with their input.
#pragma once

#include <glift/glift.h>

#include <functional>
#include <string>
#include <vector>

namespace bench {

struct AlgorithmCase {
    std::string algorithm, variant;
    /// `bytes`: the least memory traffic: input read once, output written once. Only the reads count for select and
    /// unique, whose output's size depends on the input, and for reduce and histogram, whose output is small.
    std::uint64_t elements = 0, bytes = 0;
    std::function<void(const glift::Commands&)> work;
    std::function<double()> error = nullptr;  ///< relative error of the result; null: it is exact
};

/// The algorithms of algorithms.glift, each over n elements (sorts with values: n pairs).
std::vector<AlgorithmCase> algorithm_cases(const glift::Device& device, std::uint32_t n);

/// n tridiagonal systems of n unknowns, with one right-hand side and with three: each as a case that solves the same
/// data every time, and as one (`_from_memory`) that cycles through copies of the data, which together exceed the
/// caches.
std::vector<AlgorithmCase> tridiagonal_cases(const glift::Device& device, std::uint32_t n);

}  // namespace bench
