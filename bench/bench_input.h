// The input of bench_rivals; algorithms.glift (for bench_algorithms) and cuda/rivals.cuh generate the same. Other
// benches use the hash alone.
#pragma once

#include <cstdint>
#include <vector>

namespace bench {

/// A pseudo-random bijection of 32-bit numbers.
constexpr std::uint32_t hash32(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

constexpr std::uint32_t input_seed = 0x9e3779b9u;

inline std::vector<std::uint32_t> hashed(std::uint32_t count) {
    std::vector<std::uint32_t> values(count);
    for (std::uint32_t i = 0; i < count; ++i) values[i] = hash32(i ^ input_seed);
    return values;
}

}  // namespace bench
