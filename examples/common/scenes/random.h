// Random numbers that are the same on every machine: PCG, M. E. O'Neill, 2014. An expression, or the arguments of a
// call, may draw one number at most: which of two is drawn first would be the compiler's choice.
#pragma once

#include <glift/vector.h>

#include <cstdint>

namespace scenes {

class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed * 2862933555777941757ull + 3037000493ull) {}

    std::uint32_t bits() {
        state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
        const auto mixed = static_cast<std::uint32_t>((state_ >> 18 ^ state_) >> 27);
        const auto turn = static_cast<std::uint32_t>(state_ >> 59);
        return mixed >> turn | mixed << (-turn & 31);
    }
    /// A random number from low to high; high itself only where the sum is rounded up to it.
    float between(float low, float high) { return low + (high - low) * (static_cast<float>(bits() >> 8) * 0x1p-24f); }
    /// A random point of a box. Its numbers are drawn by statements in a fixed order, since compilers may evaluate
    /// arguments in any order: z first, as g++ did when the scenes were made.
    glift::float3 inside(const glift::float3& low, const glift::float3& high) {
        const float z = between(low.z, high.z);
        const float y = between(low.y, high.y);
        const float x = between(low.x, high.x);
        return {x, y, z};
    }

private:
    std::uint64_t state_;
};

}  // namespace scenes
