// What depth of field is computed from: the lens, and a scene to be drawn or pictures with distances.
#pragma once

#include "examples/common/picture.h"
#include "examples/common/scenes/scenes.h"

#include <cstdint>
#include <optional>
#include <string>

namespace input {

/// As a photographer says it.
struct Camera {
    float focal = 0.05f;  ///< metres
    float f_stop = 2.0f;
    float focus = 4.0f;         ///< metres
    float film_width = 0.036f;  ///< metres

    float aperture() const { return focal / f_stop; }
    /// Between lens and film, when the lens is focused.
    float image_distance() const { return focal * focus / (focus - focal); }
};

/// Throws std::runtime_error where no lens is so.
void check(const Camera& camera);

/// A generated scene, or a mesh file on a table.
scenes::Scene scene(const std::string& name, float time);

/// A view through the camera: its angle is that of the film behind the lens.
camera::Camera seen_through(const camera::Camera& view, const Camera& camera, float aspect);

/// A picture with distances, and perhaps a foreground with alpha and distances of its own.
struct Pictures {
    picture::Picture all;
    std::optional<picture::Picture> front;
};

/// Reads a picture, with its own distances or those of another file, and a foreground where one is named.
Pictures pictures(const std::string& colour, const std::string& depth, const std::string& front);

}  // namespace input
