// What depth of field is computed from: pictures with distances, in up to three layers, and the lens.
#pragma once

#include "examples/common/picture.h"

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

/// Where layers are cut, as parts of the circle of what is infinitely far.
struct Cuts {
    float front = 0.1f, back = 0.5f;

    float front_distance(const Camera& camera) const { return camera.focus / (1 + front); }
    /// What the background's picture begins with: it fades in from half of its cut on (range_of in dof.glift), and what
    /// is there has to be in both pictures.
    float back_distance(const Camera& camera) const { return camera.focus / (1 - 0.5f * back); }
};

/// Colours and distances. Without layers there is `all`; else what lies before the front cut, all behind it, all behind
/// the back cut.
struct Layers {
    picture::Picture all;
    std::optional<picture::Picture> front, behind, back;
};

/// Draws a generated scene or a mesh file, `layers` 1 or 2: one picture; 3: cut by distance.
Layers of_scene(const std::string& name, float time, std::uint32_t width, std::uint32_t height, const Camera& camera,
                const Cuts& cuts, unsigned layers);

/// Reads a picture, with its own distances or those of another file, and perhaps the picture of a foreground with
/// alpha.
Layers of_files(const std::string& colour, const std::string& depth, const std::string& front);

/// What a real lens would see of a scene, by so many pinholes.
picture::Picture reference(const std::string& name, float time, std::uint32_t width, std::uint32_t height,
                           const Camera& camera, unsigned samples);

}  // namespace input
