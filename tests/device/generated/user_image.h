// An image that a program makes itself, without Glift; in VK_IMAGE_LAYOUT_GENERAL once it was cleared.
#pragma once

#include "plain_vulkan.h"

#include <vector>

class UserImage {
public:
    /// Makes the image that `wanted` describes. description() is `wanted` with the image's handle.
    UserImage(const PlainVulkan& vulkan, const glift::vulkan::UserImage& wanted);
    ~UserImage();
    UserImage(const UserImage&) = delete;

    const glift::vulkan::UserImage& description() const { return description_; }
    void clear(VkCommandBuffer commands, const VkClearColorValue& value) const;
    void clear(VkCommandBuffer commands, const VkClearDepthStencilValue& value) const;
    /// The texels, of four bytes each, of a layer of a level. Waits for the device.
    std::vector<std::uint32_t> texels(const PlainVulkan& vulkan, std::uint32_t mip, std::uint32_t layer) const;

private:
    VkImageSubresourceRange all() const;
    void order(VkCommandBuffer commands, VkImageLayout before, VkPipelineStageFlags2 stage) const;

    VkDevice device_;
    glift::vulkan::UserImage description_;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
};
