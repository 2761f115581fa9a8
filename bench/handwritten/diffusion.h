// One diffusion step as a person would write it for a CPU.
#pragma once

#include <cstdint>

namespace handwritten {

struct Extent3 {
    std::uint32_t x, y, z;
};

/// v = u + rate * (sum of the six neighbours - 6 u), x fastest; beyond the surface lies what lies on it. On all cores.
void diffuse(const float* u, float* v, Extent3 extent, float rate);

/// The same, with the vectors that the compiler's flags allow and no wider ones.
void diffuse_narrow(const float* u, float* v, Extent3 extent, float rate);

}  // namespace handwritten
