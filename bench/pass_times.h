// How long each pass of a submission takes on a Vulkan device: a second device over the same VkDevice, whose command
// buffers write a timestamp after every dispatch, rendering (with all its draws), copy, fill and clear.
#pragma once

#include <glift/glift.h>

#include <string>
#include <vector>

namespace bench {

struct PassTime {
    std::string name;  ///< of the kernel, of the runtime's own pass ("glift fill"), or of a rendering's last draw; else
                       ///< "(copy)", "(fill)", "(clear)"
    double seconds;  ///< from the end of the pass before (of the first: from the command buffer's begin) to its own end
};

/// Times passes. There may be only one at a time, and it must not live longer than `device`.
class PassTimer {
public:
    /// Throws glift::Error for the host device, which has no Vulkan.
    explicit PassTimer(const glift::Device& device);
    ~PassTimer();
    PassTimer(const PassTimer&) = delete;
    PassTimer& operator=(const PassTimer&) = delete;

    /// The second device. Its submissions take longer than those of the first, since passes no longer overlap. All that
    /// is made on it has to be destroyed before the PassTimer.
    const glift::Device& device() const { return device_; }

    /// Waits, and returns the passes of all command buffers that were submitted on the second device since the last
    /// call, in their order, also passes over no elements. If a recording was submitted several times, all its passes
    /// have the times of the last submission. Throws std::runtime_error if a command buffer has more passes than can be
    /// timed.
    std::vector<PassTime> passes();

private:
    glift::Device device_;
};

}  // namespace bench
