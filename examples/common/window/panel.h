// Dear ImGui over the picture: one context for the one window that there is.
#pragma once

#include "display.h"
#include "swapchain.h"

namespace window {

class Panel {
public:
    Panel(const Display& display, const glift::vulkan::Objects& objects, const Swapchain& swapchain);
    ~Panel();
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;

    void begin();  ///< a frame, instead of one that was begun and is not drawn
    /// Leaves out what the panel takes: presses over it, and their releases; keys and the wheel.
    void filter(Events& events);
    void draw(VkCommandBuffer commands);  ///< in the swapchain's render pass

private:
    VkDevice device_;
    VkDescriptorPool pool_ = VK_NULL_HANDLE;
    bool is_begun_ = false;
    unsigned held_ = 0;  ///< buttons that were pressed over the picture, a bit for each
};

}  // namespace window
