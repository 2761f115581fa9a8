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

/// The inside of an edge is where `a * x + b * y + c >= 0`, x and y in 1/256 of a pixel as in Point.
struct Edge {
    std::int32_t a, b;
    std::int64_t c;
};

struct Triangle {
    std::array<Edge, 3> edges;  ///< edge i is opposite vertex i
    float inverse_area;         ///< weight i is (edge function i + offset[i]) * inverse_area
    float offset[3];            ///< 1 where the top-left rule subtracted 1 from the edge function, else 0
    float z[3], inverse_w[3];
    const float* corner[3];                 ///< varyings of each vertex
    const float* flat = nullptr;            ///< varyings of the primitive's first vertex, before clipping
    std::int32_t left, top, right, bottom;  ///< pixels that may be covered; `right` and `bottom` are exclusive
    bool is_front;
};

/// The state of a draw that triangle setup needs.
struct Window {
    /// Pixels [first, end) of the viewport. `first` is 0 or 1 along each axis, even or odd as in the framebuffer, so
    /// that blocks begin at even pixels.
    uint2 first, end;
    Cull cull;
    CornerLayout layout;
};

/// A point in the window, in 1/256 of a pixel; pixel centres are multiples of 256. The guard band keeps it within 2^24.
struct Point {
    std::int32_t x, y;
};

/// A vertex, and a point in the window: where the vertex lies, or beside it for a line or a point widened to triangles.
struct Corner {
    Point point;
    float inverse_w;
    const float* vertex;
};

/// Where a vertex lies in the window, in pixels. The vertex must be inside the guard band and have w > 0.
float2 place_of(const Window& window, const float* vertex);
Point snapped(float2 place);
inline Corner corner_of(const Window& window, const float* vertex) {
    return {snapped(place_of(window, vertex)), 1.0f / vertex[3], vertex};
}
/// `corner_of` of `count` consecutive vertices. The points of those outside the guard band mean nothing.
void corners_of(const Window& window, const float* vertices, std::uint32_t count, Corner* corners);

/// Sets up a triangle, all but `flat`; none if its bounding box has no pixel centre in the viewport, or if it has no
/// area or is culled.
std::optional<Triangle> triangle_of(const Window& window, const Corner& corner0, const Corner& corner1,
                                    const Corner& corner2);

}  // namespace glift::host::raster
