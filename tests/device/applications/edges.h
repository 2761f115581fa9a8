// Where devices may cover other pixels: the geometry of edges, in double precision.
#pragma once

#include <glift/vector.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace edges {

enum class Rule {
    exact,   ///< the same rounding of corners: only clipping, which makes new ones, may differ
    rounded  ///< corners rounded to the same grid, after other arithmetic: a centre within 1/256 pixel of an edge may
             ///< differ
};

struct Difference {
    std::size_t pixels = 0;                 ///< that differ
    std::vector<glift::uint2> unexplained;  ///< those by more triangles than have an edge there
};

/// Two devices' numbers of triangles over each pixel, three places in clip coordinates each.
Difference compared(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b,
                    const std::vector<glift::float4>& places, glift::uint2 size, Rule rule);

/// Whether the pixel's centre lies where the border of some line is, two places each, as near as that is rounded.
bool is_beside_a_line(const std::vector<glift::float4>& places, glift::uint2 size, glift::uint2 pixel);

}  // namespace edges
