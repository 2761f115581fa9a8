// GLFW's window, and what happens at it.
#pragma once

#include "events.h"

#include <string>
#include <vector>

struct GLFWwindow;

namespace window {

/// Throws glift::Error (no_device) where there is no display.
class Display {
public:
    Display(const std::string& title, glift::uint2 size);
    ~Display();
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    /// Instance extensions that surfaces of this window need.
    std::vector<const char*> extensions() const;
    GLFWwindow* handle() const { return window_; }

    /// Takes what happened, or waits for it. Throws glift::Error where the display is gone.
    void poll();
    void wait(double seconds);

    glift::uint2 size() const;
    bool is_minimised() const;
    bool is_to_close() const;
    void close();

    /// What happened, with the pointer in pixels of the window; empty afterwards.
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
