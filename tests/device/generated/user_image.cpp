#include "user_image.h"

#include <algorithm>
#include <cstring>

namespace {

/// Allocates memory of the first type that the image accepts and that has the wanted properties.
VkDeviceMemory memory_for(const PlainVulkan& vulkan, const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted) {
    VkPhysicalDeviceMemoryProperties types;
    vkGetPhysicalDeviceMemoryProperties(vulkan.physical, &types);
    std::uint32_t type = 0;
    while (!(needs.memoryTypeBits >> type & 1) || (types.memoryTypes[type].propertyFlags & wanted) != wanted) ++type;
    const VkMemoryAllocateInfo info = {
        .sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, .allocationSize = needs.size, .memoryTypeIndex = type};
    VkDeviceMemory memory = VK_NULL_HANDLE;
    EXPECT_EQ(vkAllocateMemory(vulkan.device, &info, nullptr, &memory), VK_SUCCESS);
    return memory;
}

}  // namespace

UserImage::UserImage(const PlainVulkan& vulkan, const glift::vulkan::UserImage& wanted)
    : device_(vulkan.device), description_(wanted) {
    const VkImageCreateInfo info = {.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                                    .flags = wanted.flags,
                                    .imageType = VK_IMAGE_TYPE_2D,
                                    .format = wanted.format,
                                    .extent = {wanted.extent.x, wanted.extent.y, 1},
                                    .mipLevels = wanted.mips,
                                    .arrayLayers = wanted.layers,
                                    .samples = VK_SAMPLE_COUNT_1_BIT,
                                    .tiling = VK_IMAGE_TILING_OPTIMAL,
                                    .usage = wanted.usage};
    EXPECT_EQ(vkCreateImage(device_, &info, nullptr, &description_.image), VK_SUCCESS);
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(device_, description_.image, &needs);
    memory_ = memory_for(vulkan, needs, 0);
    vkBindImageMemory(device_, description_.image, memory_, 0);
}

UserImage::~UserImage() {
    vkDeviceWaitIdle(device_);
    vkDestroyImage(device_, description_.image, nullptr);
    vkFreeMemory(device_, memory_, nullptr);
}

VkImageSubresourceRange UserImage::all() const {
    const bool is_depth = description_.format == VK_FORMAT_D32_SFLOAT;
    return {VkImageAspectFlags(is_depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT), 0, description_.mips,
            0, description_.layers};
}

void UserImage::order(VkCommandBuffer commands, VkImageLayout before, VkPipelineStageFlags2 stage) const {
    const VkImageMemoryBarrier2 barrier = {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
                                           .srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                           .srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT,
                                           .dstStageMask = stage,
                                           .dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT,
                                           .oldLayout = before,
                                           .newLayout = VK_IMAGE_LAYOUT_GENERAL,
                                           .image = description_.image,
                                           .subresourceRange = all()};
    const VkDependencyInfo info = {
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .imageMemoryBarrierCount = 1, .pImageMemoryBarriers = &barrier};
    vkCmdPipelineBarrier2(commands, &info);
}

void UserImage::clear(VkCommandBuffer commands, const VkClearColorValue& value) const {
    order(commands, VK_IMAGE_LAYOUT_UNDEFINED, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT);
    const VkImageSubresourceRange range = all();
    vkCmdClearColorImage(commands, description_.image, VK_IMAGE_LAYOUT_GENERAL, &value, 1, &range);
}

void UserImage::clear(VkCommandBuffer commands, const VkClearDepthStencilValue& value) const {
    order(commands, VK_IMAGE_LAYOUT_UNDEFINED, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT);
    const VkImageSubresourceRange range = all();
    vkCmdClearDepthStencilImage(commands, description_.image, VK_IMAGE_LAYOUT_GENERAL, &value, 1, &range);
}

std::vector<std::uint32_t> UserImage::texels(const PlainVulkan& vulkan, std::uint32_t mip, std::uint32_t layer) const {
    const std::uint32_t width = std::max(description_.extent.x >> mip, 1u),
                        height = std::max(description_.extent.y >> mip, 1u);
    std::vector<std::uint32_t> values(std::size_t{width} * height);
    const VkBufferCreateInfo info = {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                     .size = 4 * values.size(),
                                     .usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT};
    VkBuffer buffer = VK_NULL_HANDLE;
    EXPECT_EQ(vkCreateBuffer(device_, &info, nullptr, &buffer), VK_SUCCESS);
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(device_, buffer, &needs);
    const VkDeviceMemory memory =
        memory_for(vulkan, needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    vkBindBufferMemory(device_, buffer, memory, 0);
    const VkCommandBuffer commands = vulkan.begin();
    order(commands, VK_IMAGE_LAYOUT_GENERAL, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT);
    const VkBufferImageCopy region = {.imageSubresource = {all().aspectMask, mip, layer, 1},
                                      .imageExtent = {width, height, 1}};
    vkCmdCopyImageToBuffer(commands, description_.image, VK_IMAGE_LAYOUT_GENERAL, buffer, 1, &region);
    vulkan.run(commands);
    void* mapped = nullptr;
    vkMapMemory(device_, memory, 0, VK_WHOLE_SIZE, 0, &mapped);
    std::memcpy(values.data(), mapped, 4 * values.size());
    vkDestroyBuffer(device_, buffer, nullptr);
    vkFreeMemory(device_, memory, nullptr);
    return values;
}
