// The input of the program: a lens, and a scene to draw or pictures with distances.
#pragma once

#include "examples/common/picture.h"
#include "examples/common/scenes/scenes.h"

#include <cstdint>
#include <optional>
#include <string>

namespace input {

/// A camera in a photographer's terms.
struct Camera {
    float focal = 0.05f;  ///< metres
    float f_stop = 2.0f;
    float focus = 4.0f;         ///< distance in focus, in metres
    float film_width = 0.036f;  ///< metres

    float aperture() const { return focal / f_stop; }
    /// The distance between lens and film when the lens is focused.
    float image_distance() const { return focal * focus / (focus - focal); }
};

/// Throws std::runtime_error if no lens has these settings.
void check(const Camera& camera);

/// The generated scene of this name at a time in seconds, or, if the name has a dot, a mesh from the file of this name,
/// placed on a table.
scenes::Scene scene(const std::string& name, float time);

/// The view with the camera's field of view, which film and lens determine.
camera::Camera seen_through(const camera::Camera& view, const Camera& camera, float aspect);

/// A picture with distances, and optionally a separate foreground with alpha and distances.
struct Pictures {
    picture::Picture all;
    std::optional<picture::Picture> front;
};

/// Reads a picture, with distances from the same file or from the file `depth`, and a foreground if `front` is not
/// empty.
Pictures pictures(const std::string& colour, const std::string& depth, const std::string& front);

}  // namespace input
