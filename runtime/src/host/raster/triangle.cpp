#include "host/raster/triangle.h"

#include <glift/host/parallel.h>

#include <algorithm>
#include <bit>

namespace glift::host::raster {

namespace {

/// Scales and moves a coordinate, nearly as a device's fused multiply-add does: the product is exact in a double, the
/// sum almost.
float in_viewport(float place, float half_size, float middle) {
    return static_cast<float>(static_cast<double>(place) * static_cast<double>(half_size) +
                              static_cast<double>(middle));
}

/// An edge with its inside to the right of its direction, y growing downwards. A pixel centre on the edge counts as
/// inside if the edge is a top edge (level, to the right) or a left edge (upwards).
Edge edge_of(const Point& from, const Point& to) {
    const std::int64_t dx = std::int64_t{to.x} - from.x, dy = std::int64_t{to.y} - from.y;
    const bool is_top_left = dy < 0 || (dy == 0 && dx > 0);
    // dx * (y - from.y) - dy * (x - from.x), with x and y in subpixels.
    const std::int64_t c = dy * from.x - dx * from.y - (is_top_left ? 0 : 1);
    return {static_cast<std::int32_t>(-dy), static_cast<std::int32_t>(dx), c};
}

/// The first pixel whose centre is at or beyond a coordinate, and the first one whose centre is beyond it.
std::int32_t first_from(std::int32_t place) { return (place + (1 << subpixel_bits) - 1) >> subpixel_bits; }
std::int32_t first_beyond(std::int32_t place) { return (place >> subpixel_bits) + 1; }

bool is_culled(Cull cull, bool is_front) {
    return (cull == Cull::back && !is_front) || (cull == Cull::front && is_front);
}

}  // namespace

float2 place_of(const Window& window, const float* vertex) {
    const float inverse_w = 1.0f / vertex[3];
    const float half_width = 0.5f * static_cast<float>(window.end.x - window.first.x);
    const float half_height = 0.5f * static_cast<float>(window.end.y - window.first.y);
    return {in_viewport(vertex[0] * inverse_w, half_width, half_width + static_cast<float>(window.first.x)),
            in_viewport(vertex[1] * inverse_w, half_height, half_height + static_cast<float>(window.first.y))};
}

/// Rounds to the subpixel grid, halves to even: adding 1.5 * 2^52 rounds to a whole number, which the low 32 bits of
/// the sum then hold.
Point snapped(float2 place) {
    const auto rounded = [](float x) {
        constexpr double whole = 0x1.8p52;
        const double sum = static_cast<double>(x - 0.5f) * (1 << subpixel_bits) + whole;
        return static_cast<std::int32_t>(std::bit_cast<std::int64_t>(sum));
    };
    return {rounded(place.x), rounded(place.y)};
}

GLIFT_HOST_KERNEL void corners_of(const Window& window, const float* vertices, std::uint32_t count, Corner* corners) {
    const std::size_t stride = window.layout.stride();
    for (std::uint32_t i = 0; i < count; ++i) corners[i] = corner_of(window, vertices + i * stride);
}

std::optional<Triangle> triangle_of(const Window& window, const Corner& corner0, const Corner& corner1,
                                    const Corner& corner2) {
    const Corner* corners[3] = {&corner0, &corner1, &corner2};
    const Point points[3] = {corner0.point, corner1.point, corner2.point};
    Triangle triangle;
    const auto [left, right] = std::minmax({points[0].x, points[1].x, points[2].x});
    const auto [top, bottom] = std::minmax({points[0].y, points[1].y, points[2].y});
    triangle.left = std::max(first_from(left), static_cast<std::int32_t>(window.first.x));
    triangle.top = std::max(first_from(top), static_cast<std::int32_t>(window.first.y));
    triangle.right = std::min(first_beyond(right), static_cast<std::int32_t>(window.end.x));
    triangle.bottom = std::min(first_beyond(bottom), static_cast<std::int32_t>(window.end.y));
    // Most small triangles contain no pixel's centre.
    if (triangle.left >= triangle.right || triangle.top >= triangle.bottom) return std::nullopt;
    const auto minus = [](std::int32_t a, std::int32_t b) { return std::int64_t{a} - b; };
    const std::int64_t area = minus(points[1].x, points[0].x) * minus(points[2].y, points[0].y) -
                              minus(points[2].x, points[0].x) * minus(points[1].y, points[0].y);
    triangle.is_front = area < 0;  // y grows downwards
    if (area == 0 || is_culled(window.cull, triangle.is_front)) return std::nullopt;

    // Clockwise in the window: the inside is to the right of every edge.
    const bool is_clockwise = area > 0;
    const std::uint32_t varyings = window.layout.varyings_at();
    for (int i = 0; i < 3; ++i) {
        const Point &a = points[(i + 1) % 3], &b = points[(i + 2) % 3];
        triangle.edges[static_cast<std::size_t>(i)] = is_clockwise ? edge_of(a, b) : edge_of(b, a);
        const Edge& edge = triangle.edges[static_cast<std::size_t>(i)];
        const bool is_top_left = edge.a > 0 || (edge.a == 0 && edge.b > 0);
        triangle.offset[i] = is_top_left ? 0.0f : 1.0f;
        triangle.inverse_w[i] = corners[i]->inverse_w;
        triangle.z[i] = corners[i]->vertex[2] * corners[i]->inverse_w;
        triangle.corner[i] = corners[i]->vertex + varyings;
    }
    triangle.inverse_area = static_cast<float>(1.0 / static_cast<double>(is_clockwise ? area : -area));
    return triangle;
}

}  // namespace glift::host::raster
