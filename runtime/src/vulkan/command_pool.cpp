#include "command_pool.h"

namespace glift::detail {

CommandPool::CommandPool(Context& context, std::uint32_t queue_family) : context_(context) {
    const VkCommandPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                          .queueFamilyIndex = queue_family};
    context.check(context.vk.vkCreateCommandPool(context.device, &pool, nullptr, &pool_), "vkCreateCommandPool");
    const VkCommandBufferAllocateInfo info = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                              .commandPool = pool_,
                                              .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                              .commandBufferCount = 1};
    const VkResult result = context.vk.vkAllocateCommandBuffers(context.device, &info, &commands_);
    if (result >= 0) return;
    context.vk.vkDestroyCommandPool(context.device, pool_, nullptr);
    context.fail(result, "vkAllocateCommandBuffers");
}

CommandPool::~CommandPool() { context_.vk.vkDestroyCommandPool(context_.device, pool_, nullptr); }

void CommandPool::begin(VkCommandBufferUsageFlags usage) {
    const VkCommandBufferBeginInfo info = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO, .flags = usage};
    context_.check(context_.vk.vkBeginCommandBuffer(commands_, &info), "vkBeginCommandBuffer");
}

bool CommandPool::reset() { return context_.vk.vkResetCommandPool(context_.device, pool_, 0) == VK_SUCCESS; }

}  // namespace glift::detail
