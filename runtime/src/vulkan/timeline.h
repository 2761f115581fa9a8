// A queue and its timeline semaphore: each submission has a number, in increasing order. Gates hold submissions back
// until the host opens them.
#pragma once

#include "context.h"

#include <chrono>
#include <mutex>

namespace glift::detail {

class Timeline {
public:
    Timeline(Context& context, VkQueue queue);
    ~Timeline();
    Timeline(const Timeline&) = delete;

    /// One thread at a time: for the device's queue its lock is held. The commands begin when this gate is open; 0: at
    /// once. Returns the submission's number.
    std::uint64_t submit(VkCommandBuffer commands, std::uint64_t gate = 0);
    std::uint64_t submitted() const { return submitted_.load(std::memory_order_acquire); }
    /// The number of a new gate, from 1 on. The device's lock is held.
    std::uint64_t new_gate() { return ++gates_; }

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
