// Dear ImGui's widgets ("the panel"), drawn over the picture of the window. There is one ImGui context, for one window.
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

    void begin();  ///< begins an ImGui frame; one that was begun and not drawn is dropped
    /// Removes the events that ImGui uses: presses over its widgets and their releases; the wheel and moves over them,
    /// but for moves while a button that was pressed over the picture is down; and keys while a widget has the
    /// keyboard's focus. Sets `is_down` of the pointer events that are left.
    void filter(Events& events);
    void draw(VkCommandBuffer commands);  ///< records commands within the swapchain's render pass

private:
    VkDevice device_;
    VkDescriptorPool pool_ = VK_NULL_HANDLE;
    bool is_begun_ = false;
    unsigned held_ = 0;  ///< a bit for each button that was pressed over the picture and is still down
};

}  // namespace window
