// The work that bench_algorithms times: algorithms of the standard library with their input.
#pragma once

#include <glift/glift.h>

#include <functional>
#include <string>
#include <vector>

namespace bench {

struct AlgorithmCase {
    std::string algorithm, variant;
    std::uint64_t elements = 0, bytes = 0;  ///< bytes: the least memory traffic: input read once, output written once
    std::function<void(const glift::Commands&)> work;
    std::function<double()> error = nullptr;  ///< relative error of the result; null: it is exact
};

/// Every algorithm over n elements.
std::vector<AlgorithmCase> algorithm_cases(const glift::Device& device, std::uint32_t n);

/// n tridiagonal systems of n unknowns, with one right-hand side and with three.
std::vector<AlgorithmCase> tridiagonal_cases(const glift::Device& device, std::uint32_t n);

}  // namespace bench
