#include "timeline.h"

#include <thread>
#include <tuple>

namespace glift::detail {

namespace {

constexpr std::chrono::microseconds soon{50}, later{1000};

VkSemaphore make_semaphore(Context& context) {
    const VkSemaphoreTypeCreateInfo type = {.sType = VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO,
                                            .semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE};
    const VkSemaphoreCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO, .pNext = &type};
    VkSemaphore semaphore = VK_NULL_HANDLE;
    context.check(context.vk.vkCreateSemaphore(context.device, &info, nullptr, &semaphore), "vkCreateSemaphore");
    return semaphore;
}

}  // namespace

Timeline::Timeline(Context& context, VkQueue queue)
    : context_(context), queue_(queue), semaphore_(make_semaphore(context)) {
    try {
        gate_semaphore_ = make_semaphore(context);
    } catch (...) {
        context.vk.vkDestroySemaphore(context.device, semaphore_, nullptr);
        throw;
    }
}

Timeline::~Timeline() {
    context_.vk.vkDestroySemaphore(context_.device, semaphore_, nullptr);
    context_.vk.vkDestroySemaphore(context_.device, gate_semaphore_, nullptr);
}

std::uint64_t Timeline::submit(VkCommandBuffer commands, const Moment& after) {
    const std::uint64_t value = submitted_ + 1;
    const VkCommandBufferSubmitInfo buffer = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
                                              .commandBuffer = commands};
    const VkSemaphoreSubmitInfo signal = {.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO,
                                          .semaphore = semaphore_,
                                          .value = value,
                                          .stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT};
    const VkSemaphoreSubmitInfo wait = {.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO,
                                        .semaphore = after.semaphore,
                                        .value = after.value,
                                        .stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT};
    const VkSubmitInfo2 info = {.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2,
                                .waitSemaphoreInfoCount = after.semaphore ? 1u : 0u,
                                .pWaitSemaphoreInfos = &wait,
                                .commandBufferInfoCount = 1,
                                .pCommandBufferInfos = &buffer,
                                .signalSemaphoreInfoCount = 1,
                                .pSignalSemaphoreInfos = &signal};
    context_.check(context_.vk.vkQueueSubmit2(queue_, 1, &info, VK_NULL_HANDLE), "vkQueueSubmit2");
    submitted_.store(value, std::memory_order_release);
    return value;
}

std::uint64_t Timeline::completed() {
    std::uint64_t value = 0;
    context_.check(context_.vk.vkGetSemaphoreCounterValue(context_.device, semaphore_, &value),
                   "vkGetSemaphoreCounterValue");
    return value;
}

bool Timeline::completes_within(std::chrono::microseconds time, std::uint64_t value) {
    const auto end = std::chrono::steady_clock::now() + time;
    do {
        if (completed() >= value) return true;
        std::this_thread::yield();
    } while (std::chrono::steady_clock::now() < end);
    return false;
}

void Timeline::wait(std::uint64_t value) {
    context_.require_not_lost();
    if (completes_within(soon, value)) return;  // vkWaitSemaphores takes 25 us longer to notice on an H200
    const VkSemaphoreWaitInfo info = {.sType = VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO,
                                      .semaphoreCount = 1,
                                      .pSemaphores = &semaphore_,
                                      .pValues = &value};
    // In parts: where gates hold submissions back, NVIDIA's driver notices up to 10 ms late that the value was reached.
    constexpr std::uint64_t part = 200'000;  // nanoseconds
    VkResult result = VK_TIMEOUT;
    while (result == VK_TIMEOUT) result = context_.vk.vkWaitSemaphores(context_.device, &info, part);
    context_.check(result, "vkWaitSemaphores");
}

void Timeline::poll(std::uint64_t value) {
    context_.require_not_lost();
    if (completes_within(later, value)) return;
    while (completed() < value) std::this_thread::sleep_for(soon);
}

void Timeline::open_gate(std::uint64_t gate) {
    const std::lock_guard lock(mutex_);
    if (gate <= open_gates_) return;
    open_gates_ = gate;
    const VkSemaphoreSignalInfo info = {
        .sType = VK_STRUCTURE_TYPE_SEMAPHORE_SIGNAL_INFO, .semaphore = gate_semaphore_, .value = gate};
    std::ignore = context_.vk.vkSignalSemaphore(context_.device, &info);
}

}  // namespace glift::detail
