// Triangle setup: edge functions from fixed-point vertices, and the data for interpolating depth and weights.
#pragma once

#include <glift/host/raster.h>

#include <optional>

namespace glift::host::raster {

/// Fractional bits of window coordinates.
inline constexpr int subpixel_bits = 8;

/// The layout of a vertex: position, clip distances, varyings.
struct CornerLayout {
    std::uint32_t clip_distances, varyings;
    std::uint32_t stride() const { return 4 + clip_distances + varyings; }
    std::uint32_t varyings_at() const { return 4 + clip_distances; }
};

/// The inside of an edge is where `a * x + b * y + c >= 0`, with pixel centres at whole x and y.
struct Edge {
    std::int32_t a, b;
    std::int64_t c;
};

struct Triangle {
    std::array<Edge, 3> edges;  ///< edge i is opposite vertex i
    float inverse_area;         ///< weight i is edge function i times this, up to rounding of c
    float offset[3];            ///< what the top-left rule subtracted from the edge functions
    float z[3], inverse_w[3];
    const float* corner[3];                 ///< varyings
    std::int32_t left, top, right, bottom;  ///< pixels that may be covered, the last ones exclusive
    bool is_front;
};

/// The state of a draw that triangle setup needs.
struct Window {
    uint2 first,
        end;  ///< its pixels; the first one is 0 or 1, as in the framebuffer, so that blocks begin at even pixels
    Cull cull;
    CornerLayout layout;
};

/// Sets up a triangle of three vertices inside the guard band, with w > 0; none if it covers no pixel or is culled.
std::optional<Triangle> triangle_of(const Window& window, const float* corner0, const float* corner1,
                                    const float* corner2);

}  // namespace glift::host::raster
