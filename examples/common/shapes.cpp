#include "shapes.h"

#include <glift/host/math.h>

#include <cmath>
#include <numbers>

namespace mesh {

namespace {

using glift::cross;
using glift::float3;
using glift::normalize;

constexpr float turn = 2 * std::numbers::pi_v<float>;

std::uint32_t add_point(Mesh& mesh, const float3& place, const float3& colour) {
    mesh.points.push_back(place);
    mesh.colours.push_back(colour);
    return static_cast<std::uint32_t>(mesh.points.size() - 1);
}

void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.corners.insert(mesh.corners.end(), {a, b, c});
}

/// Adds a quad with the given points in counter-clockwise order.
void add_quad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    add_triangle(mesh, a, b, c);
    add_triangle(mesh, a, c, d);
}

/// A unit vector perpendicular to the unit vector `along`.
float3 across(const float3& along) {
    return normalize(cross(along, std::abs(along.y) < 0.9f ? float3(0, 1, 0) : float3(1, 0, 0)));
}

}  // namespace

void add_box(Mesh& mesh, const float3& low, const float3& high, const float3& colour) {
    std::uint32_t corner[8];
    for (unsigned i = 0; i < 8; ++i)
        corner[i] =
            add_point(mesh, float3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z), colour);
    const unsigned sides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& side : sides) add_quad(mesh, corner[side[0]], corner[side[1]], corner[side[2]], corner[side[3]]);
}

void add_rod(Mesh& mesh, const float3& from, const float3& to, float from_radius, float to_radius, unsigned sides,
             const float3& colour) {
    const float3 along = to - from;
    if (!(glift::length(along) > 0)) return;
    const float3 direction = normalize(along), u = across(direction), v = cross(direction, u);
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (unsigned i = 0; i < sides; ++i) {
        const float angle = turn * static_cast<float>(i) / static_cast<float>(sides);
        const float3 out = u * std::cos(angle) + v * std::sin(angle);
        add_point(mesh, from + out * from_radius, colour);
        add_point(mesh, to + out * to_radius, colour);
    }
    for (unsigned i = 0; i < sides; ++i) {
        const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % sides);
        add_quad(mesh, a, b, b + 1, a + 1);
        if (i >= 2) {
            add_triangle(mesh, first, first + 2 * i, first + 2 * (i - 1));
            add_triangle(mesh, first + 1, first + 2 * (i - 1) + 1, first + 2 * i + 1);
        }
    }
}

void add_sphere(Mesh& mesh, const float3& centre, float radius, unsigned rings, const float3& colour) {
    const auto place = [&](float u, float v) {
        const float longitude = turn * u, latitude = turn / 2 * v;
        return centre + float3(-std::sin(latitude) * std::cos(longitude), std::cos(latitude),
                               std::sin(latitude) * std::sin(longitude)) *
                            radius;
    };
    add_sheet(mesh, 2 * rings, rings, place, [&](float, float) { return colour; });
}

void add_sheet(Mesh& mesh, unsigned columns, unsigned rows, const std::function<float3(float, float)>& place,
               const std::function<float3(float, float)>& colour) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (unsigned y = 0; y <= rows; ++y) {
        for (unsigned x = 0; x <= columns; ++x) {
            const float u = static_cast<float>(x) / static_cast<float>(columns),
                        v = static_cast<float>(y) / static_cast<float>(rows);
            add_point(mesh, place(u, v), colour(u, v));
        }
    }
    for (unsigned y = 0; y < rows; ++y) {
        for (unsigned x = 0; x < columns; ++x) {
            const std::uint32_t a = first + y * (columns + 1) + x, below = a + columns + 1;
            add_quad(mesh, a, below, below + 1, a + 1);
        }
    }
}

}  // namespace mesh
