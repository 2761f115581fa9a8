// A scene with shadows in a window, with a camera, a light and knobs.
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
    bool moves = false;  ///< the scene, with time
};

/// Until the window is closed. `scene_at` makes the scene at a moment, `save` writes the last picture.
void show_at(window::Window& window, Choice& choice, camera::Camera& view, camera::Camera& light,
             const std::function<scenes::Scene(float time)>& scene_at,
             const std::function<void(const picture::Picture&)>& save);
