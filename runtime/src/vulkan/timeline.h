// The queue and its timeline semaphore: each submission has a number, in increasing order.
#pragma once

#include "context.h"

namespace glift::detail {

class Timeline {
public:
    explicit Timeline(Context& context);
    ~Timeline();
    Timeline(const Timeline&) = delete;

    /// The device's lock is held. Returns the submission's number.
    std::uint64_t submit(VkCommandBuffer commands);
    std::uint64_t submitted() const { return submitted_.load(std::memory_order_acquire); }

    /// Both may be called from any thread.
    std::uint64_t completed();
    void wait(std::uint64_t value);

private:
    Context& context_;
    VkSemaphore semaphore_ = VK_NULL_HANDLE;
    std::atomic<std::uint64_t> submitted_{0};
};

}  // namespace glift::detail
