// Photographs in a window: sliders for the settings; a click, or a drag, sets the focus.
#pragma once

#include "examples/common/window/window.h"
#include "subject.h"

#include <functional>
#include <string>

/// Runs until the window is closed, also by Escape. S calls `save`, unless the photograph is out of date; Tab hides and
/// shows the sliders. Sliders and clicks change `settings`, which must be the object that the subject was made with.
/// `reload` is the folder of `gliftc watch`, or empty: edits of kernels are seen in the next frame.
void show_at(window::Window& window, Subject& subject, Settings& settings, const std::string& reload,
             const std::function<void()>& save);
