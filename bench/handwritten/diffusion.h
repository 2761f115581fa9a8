// A hand-written diffusion step for CPUs.
#pragma once

#include <cstdint>

namespace handwritten {

struct Extent3 {
    std::uint32_t x, y, z;
};

/// v = u + rate * (sum of the six neighbours - 6 u). x is the fastest axis; neighbours outside are clamped to the
/// border. Runs on all cores.
void diffuse(const float* u, float* v, Extent3 extent, float rate);

/// The same without function multiversioning: vectors only as wide as the compiler's flags allow.
void diffuse_narrow(const float* u, float* v, Extent3 extent, float rate);

}  // namespace handwritten
