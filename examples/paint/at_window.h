// Painting in a window.
#pragma once

#include "canvas.h"
#include "examples/common/window/window.h"

#include <functional>

/// Where the model is seen from: the eye is on a sphere around `target`, which it looks at.
struct Orbit {
    glift::float3 target;
    float turn = 0.6f, upwards = 0.3f;  ///< how far the eye is turned to the right and raised, in radians
    float closer = 1;                   ///< the sphere's radius is 1.6 / closer

    /// With a much larger `closer` the target would be before the near plane, with a much smaller one the model beyond
    /// the far plane.
    static constexpr float least_closer = 0.25f, most_closer = 100;

    camera::Camera camera() const;
};

/// Runs until the window is closed, also by Escape. The left button paints, the right one turns the model, the middle
/// one moves it, the wheel goes closer; Z undoes a stroke, Y redoes it, S calls `save`; L, B, P and T show or hide the
/// levels of pages, their borders, the pool and the table, Tab the panel. Changes `orbit`. What `save` throws is shown
/// in the panel, and painting goes on. `strokes` are those that are on the model already, and become those that are on
/// it at the end, also where this throws, as when the display is lost.
void paint_at(window::Window& window, Canvas& canvas, Orbit& orbit, painted::Layers layers, strokes::Brush brush,
              std::vector<strokes::Stroke>& strokes, const std::function<void()>& save);
