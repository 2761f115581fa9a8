// How long each pass of a submission takes on a Vulkan device: a second device over the same VkDevice, whose command
// buffers write a timestamp after every dispatch, draw, copy and fill.
#pragma once

#include <glift/glift.h>

#include <string>
#include <vector>

namespace bench {

struct PassTime {
    std::string name;  ///< the kernel's; of copies, fills and clears theirs
    double seconds;    ///< from the end of the pass before to its own end
};

/// Only one at a time, and no longer than `device`.
class PassTimer {
public:
    /// Throws glift::Error for the host device, which has no Vulkan.
    explicit PassTimer(const glift::Device& device);
    ~PassTimer();
    PassTimer(const PassTimer&) = delete;
    PassTimer& operator=(const PassTimer&) = delete;

    /// The second device. Its submissions take longer than those of the first, since passes no longer overlap. All that
    /// is made on it has to be gone before this is.
    const glift::Device& device() const { return device_; }

    /// The passes of all that the second device was given since the last call, in their order, those that run over
    /// nothing among them. Waits for them. Of a recording that was submitted several times all have the last one's
    /// times. Throws std::runtime_error where a command buffer has more passes than are timed.
    std::vector<PassTime> passes();

private:
    glift::Device device_;
};

}  // namespace bench
