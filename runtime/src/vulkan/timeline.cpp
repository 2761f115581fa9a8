#include "timeline.h"

namespace glift::detail {

Timeline::Timeline(Context& context) : context_(context) {
    const VkSemaphoreTypeCreateInfo type = {.sType = VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO,
                                            .semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE};
    const VkSemaphoreCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO, .pNext = &type};
    context.check(context.vk.vkCreateSemaphore(context.device, &info, nullptr, &semaphore_), "vkCreateSemaphore");
}

Timeline::~Timeline() { context_.vk.vkDestroySemaphore(context_.device, semaphore_, nullptr); }

std::uint64_t Timeline::submit(VkCommandBuffer commands) {
    const std::uint64_t value = submitted_ + 1;
    const VkCommandBufferSubmitInfo buffer = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
                                              .commandBuffer = commands};
    const VkSemaphoreSubmitInfo signal = {.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO,
                                          .semaphore = semaphore_,
                                          .value = value,
                                          .stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT};
    const VkSubmitInfo2 info = {.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2,
                                .commandBufferInfoCount = 1,
                                .pCommandBufferInfos = &buffer,
                                .signalSemaphoreInfoCount = 1,
                                .pSignalSemaphoreInfos = &signal};
    context_.check(context_.vk.vkQueueSubmit2(context_.queue, 1, &info, VK_NULL_HANDLE), "vkQueueSubmit2");
    submitted_.store(value, std::memory_order_release);
    return value;
}

std::uint64_t Timeline::completed() {
    std::uint64_t value = 0;
    context_.check(context_.vk.vkGetSemaphoreCounterValue(context_.device, semaphore_, &value),
                   "vkGetSemaphoreCounterValue");
    return value;
}

void Timeline::wait(std::uint64_t value) {
    context_.require_not_lost();
    const VkSemaphoreWaitInfo info = {.sType = VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO,
                                      .semaphoreCount = 1,
                                      .pSemaphores = &semaphore_,
                                      .pValues = &value};
    context_.check(context_.vk.vkWaitSemaphores(context_.device, &info, UINT64_MAX), "vkWaitSemaphores");
}

}  // namespace glift::detail
