// A scene with shadows in a window, whose camera, light and settings can be changed.
#pragma once

#include "frame.h"

#include "examples/common/window/window.h"

#include <functional>

/// What a person chooses at the window.
struct Choice {
    Settings settings;
    Method method = Method::matched;
    View view = View::picture;
    float time = 0;
    bool moves = false;  ///< whether the scene's time advances from frame to frame
};

/// Runs until the window is closed, also by Escape. `scene_at` makes the scene at a time; the key S calls `save` with
/// the last picture. What is changed at the window is changed in `choice`, `view` and `light`.
void show_at(window::Window& window, Choice& choice, camera::Camera& view, camera::Camera& light,
             const std::function<scenes::Scene(float time)>& scene_at,
             const std::function<void(const picture::Picture&)>& save);
