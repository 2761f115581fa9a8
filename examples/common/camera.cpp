#include "camera.h"

#include <glift/host/math.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace camera {

namespace {

using glift::cross;
using glift::dot;
using glift::float3;
using glift::float4;
using glift::float4x4;
using glift::normalize;

struct Frame {
    float3 right, up, back;
};

Frame frame_of(const Camera& camera) {
    const float3 back = normalize(camera.eye - camera.target), right = normalize(cross(up_of(camera), back));
    return {right, cross(back, right), back};
}

/// Makes a matrix, which is stored by columns, from its rows: they give clip coordinates x, y (down), z and w.
float4x4 from_rows(const float4& x, const float4& y, const float4& z, const float4& w) {
    float4x4 m;
    for (unsigned i = 0; i < 4; ++i) m[i] = float4(x[i], y[i], z[i], w[i]);
    return m;
}

float4 row(const float3& direction, float offset) { return float4(direction.x, direction.y, direction.z, offset); }

}  // namespace

float3 up_of(const Camera& camera) {
    const float3 across = cross(normalize(camera.up), normalize(camera.eye - camera.target));
    if (dot(across, across) > 1e-8f) return camera.up;
    return std::abs(camera.up.z) < std::abs(camera.up.y) ? float3(0, 0, -1) : float3(0, 1, 0);
}

float4x4 projection_of(const Camera& camera, float aspect) {
    const auto [right, up, back] = frame_of(camera);
    const float scale = 1 / std::tan(camera.height_angle / 2);
    const float depth = camera.far / (camera.far - camera.near);
    const float4 along = row(back * -1.0f, dot(back, camera.eye));  // gives the distance in front of the eye
    const float4 x = row(right, -dot(right, camera.eye)) * (scale / aspect);
    const float4 y = row(up, -dot(up, camera.eye)) * -scale;
    return from_rows(x, y, along * depth - float4(0, 0, 0, depth * camera.near), along);
}

float4x4 parallel_projection_of(const Camera& camera, float half_size) {
    const auto [right, up, back] = frame_of(camera);
    const float depth = 1 / (camera.far - camera.near);
    const float4 along = row(back * -1.0f, dot(back, camera.eye));
    return from_rows(row(right, -dot(right, camera.eye)) * (1 / half_size),
                     row(up, -dot(up, camera.eye)) * (-1 / half_size),
                     along * depth - float4(0, 0, 0, depth * camera.near), float4(0, 0, 0, 1));
}

CubeFace cube_face(unsigned face) {
    static const std::array<CubeFace, 6> faces = {{{{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                                                   {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                                                   {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                                                   {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
                                                   {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
                                                   {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}}};
    return faces.at(face);
}

float4x4 cube_projection_of(const float3& eye, unsigned face, float opening, float near, float far) {
    const auto [forward, right, down] = cube_face(face);
    const float depth = far / (far - near);
    const float4 along = row(forward, -dot(forward, eye));
    return from_rows(row(right, -dot(right, eye)) * (1 / opening), row(down, -dot(down, eye)) * (1 / opening),
                     along * depth - float4(0, 0, 0, depth * near), along);
}

Camera orbited(const Camera& camera, float to_the_right, float upwards, float closer) {
    const float3 arm = camera.eye - camera.target;
    const float distance = glift::length(arm);
    const float longitude = std::atan2(arm.x, arm.z) + to_the_right;
    const float latitude = std::clamp(std::asin(std::clamp(arm.y / distance, -1.0f, 1.0f)) + upwards, -1.5f, 1.5f);
    Camera moved = camera;
    moved.eye = camera.target + float3(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                                       std::cos(latitude) * std::cos(longitude)) *
                                    (distance / closer);
    return moved;
}

}  // namespace camera
