// Copies between a Vulkan device and the host on a queue of its own.
#pragma once

#include "command_pool.h"
#include "objects.h"
#include "timeline.h"

namespace glift::detail {

class VulkanDevice;

/// The device has a queue that only copies, and can import memory of the host (Context::can_link).
class VulkanLink final : public LinkObject {
public:
    explicit VulkanLink(VulkanDevice& device);

    Memory allocate(const MemoryDescription& description) override;
    std::shared_ptr<AttachedObject> attach(std::span<std::byte> bytes) override;
    void fetch(const Memory& from, AttachedObject& to, std::span<const CopyRegion> regions) override;
    void put(AttachedObject& from, const Memory& to, std::span<const CopyRegion> regions) override;

private:
    void copy(VkBuffer from, VkBuffer to, std::span<const CopyRegion> regions);

    VulkanDevice& device_;
    Timeline timeline_;
    CommandPool pool_;
};

}  // namespace glift::detail
