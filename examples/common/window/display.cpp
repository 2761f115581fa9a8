#include "display.h"

#include <glift/error.h>

#include <algorithm>
#include <optional>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#define GLFW_EXPOSE_NATIVE_X11
#include <GLFW/glfw3native.h>

namespace window {

namespace {

bool is_gone = false;  // the connection to the X server is lost: set by the handler that the constructor installs

std::string glfw_problem() {
    const char* text = nullptr;
    return glfwGetError(&text) == GLFW_NO_ERROR || !text ? std::string() : std::string(text);
}

[[noreturn]] void throw_no_window(const std::string& why) {
    throw glift::Error(glift::ErrorCode::no_device, "there is no display to open a window on", "window::Window", why,
                       "no display: set DISPLAY, or leave --window out");
}

[[noreturn]] void throw_gone() {
    throw glift::Error(glift::ErrorCode::device_lost, "the display is gone", "window::Window",
                       "the connection to it broke", "start the program again, on a display that stays");
}

Modifiers modifiers_of(int bits) {
    return {(bits & GLFW_MOD_SHIFT) != 0, (bits & GLFW_MOD_CONTROL) != 0, (bits & GLFW_MOD_ALT) != 0};
}

Modifiers modifiers_now(GLFWwindow* window) {
    const auto held = [&](int left, int right) {
        return glfwGetKey(window, left) == GLFW_PRESS || glfwGetKey(window, right) == GLFW_PRESS;
    };
    return {held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT), held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL),
            held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT)};
}

std::optional<Button> button_of(int button) {
    switch (button) {
    case GLFW_MOUSE_BUTTON_LEFT: return Button::left;
    case GLFW_MOUSE_BUTTON_RIGHT: return Button::right;
    case GLFW_MOUSE_BUTTON_MIDDLE: return Button::middle;
    default: return std::nullopt;
    }
}

glift::uint2 window_pixels(GLFWwindow* window) {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    return {static_cast<glift::uint>(std::max(width, 1)), static_cast<glift::uint>(std::max(height, 1))};
}

}  // namespace

/// The callbacks set with GLFW. ImGui's own callbacks, installed later, call these first.
struct Display::Callbacks {
    static Display& of(GLFWwindow* window) { return *static_cast<Display*>(glfwGetWindowUserPointer(window)); }

    static void on_button(GLFWwindow* window, int button, int action, int modifiers) {
        Display& display = of(window);
        const auto which = button_of(button);
        if (!which) return;
        const auto kind = action == GLFW_PRESS ? PointerEvent::Kind::press : PointerEvent::Kind::release;
        display.events_.pointer.push_back(
            {kind, *which, action == GLFW_PRESS, display.pointer_, 1, modifiers_of(modifiers)});
    }
    static void on_move(GLFWwindow* window, double x, double y) {
        Display& display = of(window);
        display.pointer_ = display.pixels_of(x, y);
        display.events_.pointer.push_back(
            {PointerEvent::Kind::move, Button::left, false, display.pointer_, 1, modifiers_now(window)});
    }
    static void on_wheel(GLFWwindow* window, double, double notches) {
        of(window).events_.wheel += static_cast<float>(notches);
    }
    static void on_key(GLFWwindow* window, int key, int, int action, int modifiers) {
        if (action == GLFW_REPEAT) return;
        of(window).events_.keys.push_back({key, action == GLFW_PRESS, modifiers_of(modifiers)});
    }
};

Display::Display(const std::string& title, glift::uint2 size) {
    if (!glfwInit()) throw_no_window(glfw_problem());
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);  // no OpenGL context: Vulkan draws
    window_ = glfwCreateWindow(static_cast<int>(size.x), static_cast<int>(size.y), title.c_str(), nullptr, nullptr);
    if (!window_) {
        const std::string why = glfw_problem();
        glfwTerminate();
        throw_no_window(why);
    }
    // Xlib calls both handlers when the connection breaks; its default ones print a line and end the program. It may
    // write through a null pointer if the second one returns: the buffer of requests may be full then.
    is_gone = false;
    XSetIOErrorHandler([](::Display*) { return 0; });
    const auto leave = [](::Display*, void*) {
        is_gone = true;
        throw_gone();
    };
    XSetIOErrorExitHandler(glfwGetX11Display(), leave, nullptr);
    glfwSetWindowUserPointer(window_, this);
    glfwSetMouseButtonCallback(window_, &Callbacks::on_button);
    glfwSetCursorPosCallback(window_, &Callbacks::on_move);
    glfwSetScrollCallback(window_, &Callbacks::on_wheel);
    glfwSetKeyCallback(window_, &Callbacks::on_key);
}

Display::~Display() {
    if (is_gone) return;  // without a connection GLFW would wait for ever
    try {
        glfwDestroyWindow(window_);
        glfwTerminate();
    } catch (const glift::Error&) {
        // The connection broke just now, and there is nothing left to close.
    }
}

std::vector<const char*> Display::extensions() const {
    std::uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    if (!names) {
        throw glift::Error(glift::ErrorCode::missing_feature, "Vulkan cannot show pictures on this display",
                           "window::Window", glfw_problem(),
                           "install a driver that can (Debian, on the CPU: apt install mesa-vulkan-drivers)");
    }
    return {names, names + count};
}

void Display::require() const {
    if (is_gone) throw_gone();
}

void Display::poll() {
    require();
    glfwPollEvents();
    require();
}

void Display::wait(double seconds) {
    require();
    glfwWaitEventsTimeout(seconds);
    require();
}

glift::uint2 Display::size() const {
    const glift::uint2 size = window_pixels(window_);
    require();  // after the call: if the connection broke in it, GLFW's size means nothing
    return size;
}

/// Converts from GLFW's screen coordinates, which on high-resolution screens are not pixels.
glift::float2 Display::pixels_of(double x, double y) const {
    int width = 1, height = 1;
    glfwGetWindowSize(window_, &width, &height);
    const glift::uint2 pixels =
        window_pixels(window_);  // not size(): GLFW calls this, and nothing may be thrown through it
    return {static_cast<float>(x * pixels.x / std::max(width, 1)),
            static_cast<float>(y * pixels.y / std::max(height, 1))};
}

bool Display::is_minimised() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    return width <= 0 || height <= 0 || glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE;
}

bool Display::is_to_close() const { return glfwWindowShouldClose(window_) == GLFW_TRUE; }
void Display::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }

Events Display::take_events() { return std::exchange(events_, Events()); }

}  // namespace window
