#include "host/raster/clip.h"

#include <algorithm>

namespace glift::host::raster {

namespace {

/// How far the guard band (clip.h) reaches at most from the viewport's centre along each axis, in pixels.
constexpr float guard_band = 32000.0f;

}  // namespace

Clipper::Clipper(const Window& window)
    : layout_(window.layout), band_x_(guard_band / std::max(1.0f, 0.5f * static_cast<float>(window.end.x))),
      band_y_(guard_band / std::max(1.0f, 0.5f * static_cast<float>(window.end.y))) {}

/// A linear function of the vertex that is zero on a plane and not negative inside; from plane 6 on, a clip distance of
/// the program. Inside both depth planes w >= z >= 0; so, of the vertices that clipping leaves, only those with w = 0
/// have no position in the window.
float Clipper::distance(unsigned plane, const float* corner) const {
    const float x = corner[0], y = corner[1], z = corner[2], w = corner[3];
    switch (plane) {
    case 0: return z;
    case 1: return w - z;
    case 2: return band_x_ * w - x;
    case 3: return band_x_ * w + x;
    case 4: return band_y_ * w - y;
    case 5: return band_y_ * w + y;
    default: return corner[4 + plane - 6];
    }
}

/// Looks at all planes without a branch for each, since nearly all vertices are inside. False for NaN, too.
bool Clipper::is_inside(const float* corner) const {
    const float x = corner[0], y = corner[1], z = corner[2], w = corner[3];
    bool inside = (w > 0.0f) & (z >= 0.0f) & (w - z >= 0.0f) & (band_x_ * w - x >= 0.0f) & (band_x_ * w + x >= 0.0f) &
                  (band_y_ * w - y >= 0.0f) & (band_y_ * w + y >= 0.0f);
    for (unsigned plane = 6; plane < planes(); ++plane) inside &= distance(plane, corner) >= 0.0f;
    return inside;
}

const float* Clipper::between(const float* in, const float* out, float t, MadeCorners& made) const {
    std::vector<float>& corner = made.emplace_back(layout_.stride());
    for (std::size_t i = 0; i < corner.size(); ++i) corner[i] = in[i] + t * (out[i] - in[i]);
    return corner.data();
}

/// Sutherland and Hodgman, Reentrant Polygon Clipping, 1974. A new vertex is interpolated from the vertex inside
/// towards the one outside, so that two triangles with a common edge get the same vertex.
Polygon Clipper::cut(const Polygon& polygon, unsigned plane, MadeCorners& made) const {
    Polygon result;
    for (unsigned i = 0; i < polygon.count && result.count + 2 <= max_polygon; ++i) {
        const float *from = polygon.corners[i], *to = polygon.corners[(i + 1) % polygon.count];
        const float a = distance(plane, from), b = distance(plane, to);
        const bool from_inside = a >= 0.0f, to_inside = b >= 0.0f;
        if (from_inside) result.corners[result.count++] = from;
        if (from_inside && !to_inside) result.corners[result.count++] = between(from, to, a / (a - b), made);
        if (!from_inside && to_inside) result.corners[result.count++] = between(to, from, b / (b - a), made);
    }
    return result;
}

bool Clipper::clip_line(const float*& from, const float*& to, MadeCorners& made) const {
    if (is_inside(from) && is_inside(to)) return true;
    for (unsigned plane = 0; plane < planes(); ++plane) {
        const float a = distance(plane, from), b = distance(plane, to);
        if (!(a >= 0.0f) && !(b >= 0.0f)) return false;
        if (!(b >= 0.0f)) to = between(from, to, a / (a - b), made);
        if (!(a >= 0.0f)) from = between(to, from, b / (b - a), made);
    }
    return from[3] > 0.0f && to[3] > 0.0f;
}

Polygon Clipper::clipped(const float* corner0, const float* corner1, const float* corner2, MadeCorners& made) const {
    Polygon polygon{{corner0, corner1, corner2}, 3};
    if (is_inside(corner0) && is_inside(corner1) && is_inside(corner2)) return polygon;
    for (unsigned plane = 0; plane < planes() && polygon.count >= 3; ++plane) polygon = cut(polygon, plane, made);
    const auto has_no_place = [](const float* corner) { return !(corner[3] > 0.0f); };
    if (polygon.count < 3 ||
        std::any_of(polygon.corners.begin(), polygon.corners.begin() + polygon.count, has_no_place))
        return {};
    return polygon;
}

}  // namespace glift::host::raster
