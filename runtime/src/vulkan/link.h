// Copies between a Vulkan device and the host on a queue of its own.
#pragma once

#include "objects.h"
#include "timeline.h"

namespace glift::detail {

class VulkanDevice;

/// The device has a queue that only copies, and can import memory of the host (Context::can_link).
class VulkanLink final : public LinkObject {
public:
    explicit VulkanLink(VulkanDevice& device);
    ~VulkanLink() override;

    Memory allocate(const MemoryDescription& description) override;
    std::shared_ptr<AttachedObject> attach(std::span<std::byte> bytes) override;
    void fetch(const Memory& from, AttachedObject& to, std::span<const CopyRegion> regions) override;
    void put(AttachedObject& from, const Memory& to, std::span<const CopyRegion> regions) override;

private:
    void copy(VkBuffer from, VkBuffer to, std::span<const CopyRegion> regions);

    VulkanDevice& device_;
    Timeline timeline_;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
};

}  // namespace glift::detail
