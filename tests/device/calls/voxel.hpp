#pragma once

#include <cstdint>

struct Voxel {
    float density = 0;
    std::uint32_t age = 0;
};
