// A GLFW window and its input events.
#pragma once

#include "events.h"

#include <string>
#include <vector>

struct GLFWwindow;

namespace window {

/// A window on the screen. The constructor throws glift::Error (no_device) if there is no display.
class Display {
public:
    Display(const std::string& title, glift::uint2 size);
    ~Display();
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    /// Vulkan instance extensions that a surface of this window needs.
    std::vector<const char*> extensions() const;
    GLFWwindow* handle() const { return window_; }

    /// Collect input events. wait() waits until there is one, `seconds` at most. Both throw glift::Error (device_lost)
    /// if the connection to the display is lost.
    void poll();
    void wait(double seconds);

    glift::uint2 size() const;
    bool is_minimised() const;
    bool is_to_close() const;
    void close();

    /// Returns the collected events and removes them. Pointer positions are in pixels of the window.
    Events take_events();

private:
    struct Callbacks;
    void require() const;
    glift::float2 pixels_of(double x, double y) const;

    GLFWwindow* window_ = nullptr;
    Events events_;
    glift::float2 pointer_;
};

}  // namespace window
