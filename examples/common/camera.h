// A pinhole camera in a right-handed world. Projections are to Vulkan's clip coordinates: depth 0 at the near plane, 1
// at the far plane, y down.
#pragma once

#include <glift/vector.h>

namespace camera {

struct Camera {
    glift::float3 eye{0, 0, 1}, target{0, 0, 0}, up{0, 1, 0};
    float height_angle = 0.8f;  ///< vertical field of view in radians
    float near = 0.1f, far = 100.0f;

    bool operator==(const Camera&) const = default;
};

/// The camera's `up`; another axis if the camera looks along `up`, which then does not say how the picture is turned.
glift::float3 up_of(const Camera& camera);

/// The matrix from world to clip coordinates, for a picture `aspect` times as wide as high.
glift::float4x4 projection_of(const Camera& camera, float aspect);

/// The matrix of a parallel projection, for directional lights and maps: it shows `half_size` to each side of `target`.
glift::float4x4 parallel_projection_of(const Camera& camera, float half_size);

/// The axes of a face of a cube, in the order and with the directions of std.image's cubes.
struct CubeFace {
    glift::float3 forward, right, down;
};
CubeFace cube_face(unsigned face);

/// The matrix of the view from `eye` to a face of a cube around it; `opening` is the tangent of half its angle, 1 for
/// 90 degrees.
glift::float4x4 cube_projection_of(const glift::float3& eye, unsigned face, float opening, float near, float far);

/// The camera moved on a sphere around its target, by angles in radians, its distance to the target divided by
/// `closer`. A positive `to_the_right` moves the eye to the right, so that the scene turns to the left; `upwards`
/// raises the eye. The eye's latitude is clamped to [-1.5, 1.5] (y is up).
Camera orbited(const Camera& camera, float to_the_right, float upwards, float closer);

}  // namespace camera
