#pragma once

#include "vectors.hpp"

#include <array>
#include <cstdint>

namespace sim {

enum class Kind : std::uint32_t { gas, dust };

struct Spin {
    float3 axis;
    double rate;
};

struct Particle {
    float3 position;
    float mass;
    std::array<std::array<float, 3>, 2> grid;
    int neighbours[4];
    Kind kind;
    std::uint64_t id;
    Spin spin;
    Spin history[2];
    vec<2, std::uint32_t> cell;
};

struct WithPointer {
    float a;
    float* values;
};

struct Base {
    float a;
};

struct Derived : Base {
    float b;
};

struct WithBits {
    unsigned a : 3;
};

}  // namespace sim

namespace other {
struct Base {
    float a;
};
}  // namespace other

namespace sim {

template <class T> struct Pair {
    T first, second;
};

struct WithInstance {
    Pair<float> both;
};

}  // namespace sim

namespace tagged {

template <class T, int N, class Tag> struct vec {
    T parts[N];
};

struct Body {
    vec<float, 3, int> position;
};

}  // namespace tagged
