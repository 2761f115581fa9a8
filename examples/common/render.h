// Scenes drawn on the host, in sunlight and skylight without shadows: pinhole pictures with depth, and what a lens of
// some width sees, by many pinholes.
#pragma once

#include "picture.h"
#include "scenes/scenes.h"

namespace render {

/// What is nearer or farther along the camera's axis is cut off.
struct Cuts {
    float near = 0.0f, far = 1e30f;
};

/// A place on a lens, and the distance at which all places see the same.
struct LensPoint {
    float right = 0.0f, up = 0.0f;
    float focus = 1.0f;
};

/// Colour with alpha 1 and the distance along the axis; where nothing is, the sky with alpha 0 and the camera's far
/// distance.
picture::Picture drawn(const scenes::Scene& scene, std::uint32_t width, std::uint32_t height, const Cuts& cuts = {},
                       const LensPoint& point = {});

/// The mean of `samples` pinholes over a round lens, with the sky where nothing is.
picture::Picture through_lens(const scenes::Scene& scene, std::uint32_t width, std::uint32_t height, float diameter,
                              float focus, unsigned samples);

/// Colours before the sky: alpha 1 everywhere.
picture::Picture before_sky(picture::Picture picture);

}  // namespace render
