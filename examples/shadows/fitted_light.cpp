#include "fitted_light.h"

#include <glift/host/math.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace {

using glift::float3;

/// A light's axes, at right angles: the last one looks forward. Those of a point light are the world's, as are those of
/// its faces.
std::array<float3, 3> axes_of(const camera::Camera& light, LightKind kind) {
    if (kind == LightKind::point) return {float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1)};
    const float3 forward = glift::normalize(light.target - light.eye);
    const float3 right = glift::normalize(glift::cross(forward, camera::up_of(light)));
    return {right, glift::cross(forward, right), forward};
}

/// The largest absolute value of a component: for a place relative to a point light, its distance along the axis of the
/// face that sees it.
float longest_of(const float3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// A lower bound of `longest_of` over the points of a triangle: the larger one of the bounds for its bounding box and
/// for its plane.
float least_of(const std::array<float3, 3>& corners) {
    const auto [a, b, c] = corners;
    float least = 0;
    for (unsigned i = 0; i < 3; ++i)
        least = std::max({least, std::min({a[i], b[i], c[i]}), -std::max({a[i], b[i], c[i]})});
    const float3 normal = glift::cross(b - a, c - a);
    const float sum = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
    return sum > 0 ? std::max(least, std::abs(glift::dot(normal, a)) / sum) : least;
}

/// The least and the largest distance of points along the axis of a parallel light.
std::pair<float, float> range_along(const float3& forward, const scenes::Scene& scene) {
    std::pair range(std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest());
    for (const float3& point : scene.mesh.points) {
        const float away = glift::dot(forward, point - scene.light.eye);
        range = {std::min(range.first, away), std::max(range.second, away)};
    }
    return range;
}

}  // namespace

camera::Camera fitted_light(const scenes::Scene& scene, LightKind kind, float opening) {
    constexpr float more = 0.001f;  // for rounding
    camera::Camera light = scene.light;
    const std::array<float3, 3> axes = axes_of(light, kind);
    if (kind == LightKind::directional) {
        const auto [least, most] = range_along(axes[2], scene);
        const float around = more * (most - least + scene.light_half_size);
        light.near = least - around, light.far = most + around;
        return light;
    }
    const auto in_light_space = [&](std::size_t corner) {
        const float3 way = scene.mesh.points[scene.mesh.corners[corner]] - light.eye;
        return float3(glift::dot(axes[0], way), glift::dot(axes[1], way), glift::dot(axes[2], way));
    };
    float least = std::numeric_limits<float>::max(), most = 0;
    for (std::size_t i = 0; i < scene.mesh.corners.size(); i += 3) {
        const std::array<float3, 3> corners = {in_light_space(i), in_light_space(i + 1), in_light_space(i + 2)};
        least = std::min(least, least_of(corners));
        for (const float3& corner : corners)
            most = std::max(most, kind == LightKind::point ? longest_of(corner) : corner.z);
    }
    light.far = std::max(light.far, (1 + more) * most);
    // Of a point in sight, the components across are at most `opening` times the one forward.
    const float before_all = (1 - more) * least / std::max(opening, 1.0f);
    // If a spot light sees no triangle, that distance means nothing, and may be beyond `far`.
    light.near = std::max(light.near, std::min(before_all, 0.99f * light.far));
    return light;
}
