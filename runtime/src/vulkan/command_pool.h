// A command buffer with a pool of its own, so that it is reset at little cost.
#pragma once

#include "context.h"

namespace glift::detail {

class CommandPool {
public:
    CommandPool(Context& context, std::uint32_t queue_family);
    ~CommandPool();
    CommandPool(const CommandPool&) = delete;

    VkCommandBuffer commands() const { return commands_; }
    void begin(VkCommandBufferUsageFlags usage);
    [[nodiscard]] bool reset();  ///< false: it failed, and the command buffer is unusable

private:
    Context& context_;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
};

}  // namespace glift::detail
