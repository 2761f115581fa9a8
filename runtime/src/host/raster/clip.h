// Clipping, in clip coordinates, of triangles and lines against the depth range, the guard band (a square around the
// viewport's centre, in which the fixed-point arithmetic of the rasteriser does not overflow) and the program's clip
// distances.
#pragma once

#include "host/raster/triangle.h"

#include <deque>
#include <vector>

namespace glift::host::raster {

/// The most vertices of a polygon. Each plane that cuts a polygon adds one vertex at most: there are six planes, and up
/// to eight clip distances. Rounding may add some more.
inline constexpr unsigned max_polygon = 32;

/// Vertices made by clipping. Their addresses are stable.
using MadeCorners = std::deque<std::vector<float>>;

/// A convex polygon of vertices, each a row of floats.
struct Polygon {
    std::array<const float*, max_polygon> corners;
    unsigned count = 0;
};

class Clipper {
public:
    explicit Clipper(const Window& window);

    /// Moves each end of a line that lies outside a plane to where the line meets that plane; false where nothing of
    /// the line is left, or an end is left with w <= 0.
    bool clip_line(const float*& from, const float*& to, MadeCorners& made) const;
    /// Whether a vertex lies inside all planes, with w > 0.
    bool is_inside(const float* corner) const;

    /// The part of a triangle inside all planes: the triangle itself, a polygon with new vertices, or an empty polygon
    /// (also where a vertex of the part does not have w > 0).
    Polygon clipped(const float* corner0, const float* corner1, const float* corner2, MadeCorners& made) const;

private:
    unsigned planes() const { return 6 + layout_.clip_distances; }
    float distance(unsigned plane, const float* corner) const;
    Polygon cut(const Polygon& polygon, unsigned plane, MadeCorners& made) const;
    const float* between(const float* in, const float* out, float t, MadeCorners& made) const;

    CornerLayout layout_;
    float band_x_, band_y_;  ///< the guard band, in units of w
};

}  // namespace glift::host::raster
