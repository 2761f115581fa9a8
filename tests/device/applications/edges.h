// Says where two correct devices may cover different pixels: near edges of triangles and lines. Computed in double
// precision.
#pragma once

#include <glift/vector.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace edges {

enum class Rule {
    exact,   ///< devices round vertices to the same positions: only clipping, which makes new vertices, explains
             ///< differences
    rounded  ///< devices compute vertices differently before they round them to the same grid: pixels whose centres are
             ///< within 1/256 pixel of an edge may differ, too
};

struct Difference {
    std::size_t pixels = 0;                 ///< number of pixels that differ
    std::vector<glift::uint2> unexplained;  ///< pixels that differ by more triangles than have an edge near the centre
};

/// Compares two devices' numbers of triangles over each pixel. `places` are the vertices in clip coordinates, three per
/// triangle.
Difference compared(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b,
                    const std::vector<glift::float4>& places, glift::uint2 size, Rule rule);

/// Whether a pixel's centre is so near to the border of some line (one pixel wide) that rounding may decide. `places`
/// has two vertices per line.
bool is_beside_a_line(const std::vector<glift::float4>& places, glift::uint2 size, glift::uint2 pixel);

}  // namespace edges
