// Photographs in a window: sliders for the settings, a click sets the focus.
#pragma once

#include "examples/common/window/window.h"
#include "subject.h"

#include <functional>

/// Runs until the window is closed, also by Escape. S calls `save`; Tab hides and shows the sliders. They change
/// `settings`, which must be those of the subject.
void show_at(window::Window& window, Subject& subject, Settings& settings, const std::function<void()>& save);
