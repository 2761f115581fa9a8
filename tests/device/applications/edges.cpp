#include "edges.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace edges {

namespace {

using glift::float4;
using glift::uint2;

bool leaves_the_view(const float4& p) {
    return !(std::abs(p.x) <= p.w && std::abs(p.y) <= p.w && p.z >= 0 && p.z <= p.w);
}

/// A vertex in clip coordinates, in double precision.
using Place = std::array<double, 4>;

Place place_of(const float4& p) {
    return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z), static_cast<double>(p.w)};
}

/// The distance of a pixel's centre to the infinite line through two vertices, in pixels.
double distance_to_line(const Place& a, const Place& b, uint2 size, std::uint32_t x, std::uint32_t y) {
    const auto in_window = [&](const Place& p) {
        return std::array<double, 3>{(p[0] + p[3]) * size.x / 2, (p[1] + p[3]) * size.y / 2, p[3]};
    };
    const auto p = in_window(a), q = in_window(b);
    const double line[] = {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
    return std::abs(line[0] * (x + 0.5) + line[1] * (y + 0.5) + line[2]) / std::hypot(line[0], line[1]);
}

/// The points where the near or the far plane cuts a triangle's edges.
std::vector<Place> cuts_of(const Place (&corners)[3], bool is_far) {
    const auto height = [&](const Place& p) { return is_far ? p[3] - p[2] : p[2]; };
    std::vector<Place> cuts;
    for (int k = 0; k < 3; ++k) {
        const Place &a = corners[k], &b = corners[(k + 1) % 3];
        if ((height(a) < 0) == (height(b) < 0)) continue;
        const double t = height(a) / (height(a) - height(b));
        cuts.push_back({});
        for (std::size_t i = 0; i < 4; ++i) cuts.back()[i] = a[i] + t * (b[i] - a[i]);
    }
    return cuts;
}

/// Of a clipped triangle: whether the line through one of its edges, or through an edge that clipping at the near or
/// far plane makes, is so near to the pixel's centre that rounding may decide.
bool has_clipped_edge_at(const Place (&corners)[3], uint2 size, std::uint32_t x, std::uint32_t y) {
    // A corner is moved by at most half a step of 1/256 in x and in y, the diagonal 0.71 / 256, before and again after
    // clipping: 1.42 / 256.
    constexpr double rounding = 1.5 / 256;
    const auto is_near = [&](const Place& a, const Place& b) { return distance_to_line(a, b, size, x, y) <= rounding; };
    for (int k = 0; k < 3; ++k)
        if (is_near(corners[k], corners[(k + 1) % 3])) return true;
    for (const bool is_far : {false, true}) {
        const std::vector<Place> cuts = cuts_of(corners, is_far);
        if (cuts.size() == 2 && is_near(cuts[0], cuts[1])) return true;
    }
    return false;
}

/// The distance of a pixel's centre to the line segment between two vertices, in pixels; both are in front of the eye.
double distance_to_segment(const Place& a, const Place& b, uint2 size, std::uint32_t x, std::uint32_t y) {
    const double left = (a[0] / a[3] + 1) * size.x / 2, top = (a[1] / a[3] + 1) * size.y / 2;
    const double dx = (b[0] / b[3] + 1) * size.x / 2 - left, dy = (b[1] / b[3] + 1) * size.y / 2 - top;
    const double px = x + 0.5 - left, py = y + 0.5 - top, length = dx * dx + dy * dy;
    const double t = length > 0 ? std::clamp((px * dx + py * dy) / length, 0.0, 1.0) : 0;
    return std::hypot(px - t * dx, py - t * dy);
}

/// Whether an edge of a triangle that is not clipped is within 1/256 of a pixel of the pixel's centre.
bool has_whole_edge_at(const Place (&corners)[3], uint2 size, std::uint32_t x, std::uint32_t y) {
    for (int k = 0; k < 3; ++k)
        if (distance_to_segment(corners[k], corners[(k + 1) % 3], size, x, y) <= 1.0 / 256) return true;
    return false;
}

/// How many triangles have an edge so near to the pixel's centre that devices may disagree on which side of it the
/// centre is.
std::uint32_t edges_at(const std::vector<float4>& places, uint2 size, std::uint32_t x, std::uint32_t y, Rule rule) {
    std::uint32_t found = 0;
    for (std::size_t i = 0; i + 3 <= places.size(); i += 3) {
        const Place corners[] = {place_of(places[i]), place_of(places[i + 1]), place_of(places[i + 2])};
        const bool is_clipped =
            leaves_the_view(places[i]) || leaves_the_view(places[i + 1]) || leaves_the_view(places[i + 2]);
        found += is_clipped ? has_clipped_edge_at(corners, size, x, y)
                            : rule == Rule::rounded && has_whole_edge_at(corners, size, x, y);
    }
    return found;
}

/// The ends of a line in window coordinates, after it was cut at the near and the far plane: none where nothing is
/// between the planes. An end with w = 0, which has no window coordinates, is left out.
std::vector<std::array<double, 2>> ends_of(const Place& a, const Place& b, uint2 size) {
    double from = 0, to = 1;
    const auto cut = [&](double first, double second) {
        if (first < 0 && second < 0) to = -1;
        else if (first < 0) from = std::max(from, first / (first - second));
        else if (second < 0) to = std::min(to, first / (first - second));
    };
    cut(a[2], b[2]);
    cut(a[3] - a[2], b[3] - b[2]);
    std::vector<std::array<double, 2>> ends;
    for (const double t : {from, to}) {
        Place p;
        for (std::size_t i = 0; i < 4; ++i) p[i] = a[i] + t * (b[i] - a[i]);
        if (from <= to && p[3] > 0) ends.push_back({(p[0] / p[3] + 1) * size.x / 2, (p[1] / p[3] + 1) * size.y / 2});
    }
    return ends;
}

}  // namespace

bool is_beside_a_line(const std::vector<float4>& places, uint2 size, uint2 pixel) {
    constexpr double rounding = 2.0 / 256;
    for (std::size_t i = 0; i + 2 <= places.size(); i += 2) {
        const auto ends = ends_of(place_of(places[i]), place_of(places[i + 1]), size);
        if (ends.size() < 2) continue;
        const double dx = ends[1][0] - ends[0][0], dy = ends[1][1] - ends[0][1], length = std::hypot(dx, dy);
        const double x = pixel.x + 0.5 - ends[0][0], y = pixel.y + 0.5 - ends[0][1];
        const double aside = std::abs(x * dy - y * dx) / length, along = (x * dx + y * dy) / length;
        const bool is_within = along > -rounding && along < length + rounding && aside < 0.5 + rounding;
        const bool is_at_end = std::min(std::abs(along), std::abs(along - length)) < rounding;
        if (is_within && (is_at_end || std::abs(aside - 0.5) < rounding)) return true;
    }
    return false;
}

Difference compared(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b,
                    const std::vector<float4>& places, uint2 size, Rule rule) {
    Difference found;
    for (std::uint32_t i = 0; i < a.size(); ++i) {
        if (a[i] == b[i]) continue;
        ++found.pixels;
        const std::uint32_t apart = std::max(a[i], b[i]) - std::min(a[i], b[i]);
        const uint2 pixel(i % size.x, i / size.x);
        if (apart > edges_at(places, size, pixel.x, pixel.y, rule)) found.unexplained.push_back(pixel);
    }
    return found;
}

}  // namespace edges
