// A pinhole camera, right-handed, as Vulkan's clip coordinates want it: depth 0 at the near plane, 1 at the far one, y
// down.
#pragma once

#include <glift/vector.h>

namespace camera {

struct Camera {
    glift::float3 eye{0, 0, 1}, target{0, 0, 0}, up{0, 1, 0};
    float height_angle = 0.8f;  ///< of the picture, from bottom to top, in radians
    float near = 0.1f, far = 100.0f;
};

/// From the world to clip coordinates, for a picture `aspect` times as wide as high.
glift::float4x4 projection_of(const Camera& camera, float aspect);

/// For a directional light, or a map: a box around `target`, `half_size` to each side of it.
glift::float4x4 parallel_projection_of(const Camera& camera, float half_size);

/// Around the target by angles, closer by a factor.
Camera orbited(const Camera& camera, float to_the_right, float upwards, float closer);

}  // namespace camera
