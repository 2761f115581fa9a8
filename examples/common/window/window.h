// A window for the examples. It opens the Glift device, shows a picture in each frame with Dear ImGui's widgets over
// it, and gives input events. Programs that open no window need no display.
//
//     window::Window window("title", {960, 640});
//     shown::Shown shown(window.device(), {960, 640});  // of module shown.glift
//     while (window.next()) {
//         … window.events(), ImGui::SliderFloat(…), passes that write `shown` …
//         window.show(shown.data());
//     }
#pragma once

#include "events.h"

#include <glift/device.h>
#include <glift/memory.h>
#include <glift/vector.h>

#include <memory>
#include <string>

namespace window {

class Window {
public:
    /// Opens a window of this size in pixels, and the Vulkan device that GLIFT_DEVICE names (unset: the best one), with
    /// the extensions that a window needs. Throws glift::Error: no_device if there is no display, wrong_argument if
    /// GLIFT_DEVICE is `host`, missing_feature if the device cannot show pictures there.
    Window(const std::string& title, glift::uint2 size);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    const glift::Device& device() const;

    /// Begins the next frame, after which ImGui functions may be called; false once the window is to be closed. `next`
    /// is for pictures that move: it does not wait for events. `next_event` waits for one, a tenth of a second at most,
    /// and not at all in the first three frames and in the three after an event, in which ImGui still reacts to it.
    /// Both throw glift::Error if the connection to the display is lost or the validation layer has reported an error
    /// or a warning.
    bool next();
    bool next_event();
    void close();  ///< makes the next `next` or `next_event` return false

    const Events& events() const;
    glift::uint2 size() const;  ///< the current size in pixels; at least 1
    bool is_minimised() const;  ///< nothing of the window is visible: no picture need be made

    /// Shows a picture, and the widgets over it. The picture is an image2d of format rgba8 on the device, as
    /// shown.glift makes it. It is shown unscaled if it has the window's size, else as large as it fits, filtered, on
    /// black. Returns before the device is done; commands that write the picture may follow at once, since they run
    /// after its copy.
    void show(const glift::Memory& picture);

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace window
