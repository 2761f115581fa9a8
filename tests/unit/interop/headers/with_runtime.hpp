#pragma once

#include <glift/vector.h>

#include <array>

struct Body {
    glift::vec<float, 3> position;
    float mass;
    std::array<glift::vec<glift::uint, 4>, 2> cells;
};
