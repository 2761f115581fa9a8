// A queue and its timeline semaphore: each submission has a number, in increasing order. Gates hold submissions back
// until the host opens them.
#pragma once

#include "context.h"

#include <chrono>
#include <mutex>

namespace glift::detail {

/// A value that a timeline semaphore has reached, or will.
struct Moment {
    VkSemaphore semaphore = VK_NULL_HANDLE;  ///< null: any moment
    std::uint64_t value = 0;
};

class Timeline {
public:
    Timeline(Context& context, VkQueue queue);
    ~Timeline();
    Timeline(const Timeline&) = delete;

    /// One thread at a time: for the device's queue its lock is held. The commands begin after a moment, and see what
    /// was written before it. Returns the submission's number.
    std::uint64_t submit(VkCommandBuffer commands, const Moment& after = {});
    std::uint64_t submitted() const { return submitted_.load(std::memory_order_acquire); }
    /// The number of a new gate, from 1 on. The device's lock is held.
    std::uint64_t new_gate() { return ++gates_; }
    Moment opening_of(std::uint64_t gate) const { return {gate_semaphore_, gate}; }
    Moment now() { return {semaphore_, completed()}; }

    /// These may be called from any thread.
    std::uint64_t completed();
    void wait(std::uint64_t value);
    /// As wait, sooner, and with more of the processor's time: asks again and again.
    void poll(std::uint64_t value);
    void open_gate(std::uint64_t gate);  ///< and those before it; throws nothing, since waits find a lost device

private:
    bool completes_within(std::chrono::microseconds time, std::uint64_t value);

    Context& context_;
    VkQueue queue_;
    VkSemaphore semaphore_ = VK_NULL_HANDLE, gate_semaphore_ = VK_NULL_HANDLE;
    std::atomic<std::uint64_t> submitted_{0};
    std::uint64_t gates_ = 0;  ///< made
    std::mutex mutex_;         ///< of `open_gates_`
    std::uint64_t open_gates_ = 0;
};

}  // namespace glift::detail
