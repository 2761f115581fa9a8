// Photographs in a window: sliders for the settings, a click sets the focus.
#pragma once

#include "examples/common/window/window.h"
#include "subject.h"

#include <functional>

/// Until the window is closed: by itself, or with Escape. S calls `save`; Tab hides the sliders and shows them. The
/// settings are those of the subject.
void show_at(window::Window& window, Subject& subject, Settings& settings, const std::function<void()>& save);
