// Painting in a window.
#pragma once

#include "canvas.h"
#include "examples/common/window/window.h"

#include <functional>

/// Where the model is seen from: around its middle, or another place.
struct Orbit {
    glift::float3 target;
    float turn = 0.6f, upwards = 0.3f;  ///< radians
    float closer = 1;

    camera::Camera camera() const;
};

/// Until the window is closed: by itself, or with Escape. The left button paints, the right one turns the model, the
/// middle one moves it, the wheel goes closer; Z undoes, Y does again, S calls `save`, L and B show levels and borders,
/// P the pool, T the table, Tab hides the panel. Gives the strokes that are there at the end.
std::vector<strokes::Stroke> paint_at(window::Window& window, Canvas& canvas, Orbit& orbit, painted::Layers layers,
                                      strokes::Brush brush, std::vector<strokes::Stroke> strokes,
                                      const std::function<void()>& save);
