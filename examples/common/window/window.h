// A window for the examples: it opens the device, shows a picture that Glift made in each frame, with a panel of Dear
// ImGui over it, and says what the person does. Programs that open none need no display.
//
//     window::Window window("title", {960, 640});
//     const structures(window.device(), …);
//     while (window.next()) {
//         … window.events(), ImGui::SliderFloat(…), passes on window.device() …
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
    /// Opens a window with so many pixels, and the device that GLIFT_DEVICE names, with what a window needs. Throws
    /// glift::Error: no_device without a display, missing_feature where the device cannot show pictures there.
    Window(const std::string& title, glift::uint2 size);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    const glift::Device& device() const;

    /// Begins the next frame, after which functions of ImGui make the panel; false once the window is to be closed.
    /// `next` is for pictures that move: it takes what has happened. `next_event` waits until something has, a tenth of
    /// a second at most. Both throw glift::Error where the display is gone, and with what the validation layer said.
    bool next();
    bool next_event();
    void close();  ///< the next frame is the last one

    const Events& events() const;
    glift::uint2 size() const;  ///< in pixels, as it is now; at least 1
    bool is_minimised() const;  ///< nothing is seen: no picture need be made

    /// Shows a picture and the panel: an image2d of format rgba8 of the device, as shown.glift makes it. It is seen
    /// pixel by pixel where it has the window's size, else as large as it fits, filtered, on black. Returns before that
    /// is done; the picture may be changed by later commands at once.
    void show(const glift::Memory& picture);

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace window
