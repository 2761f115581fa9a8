// Vulkan objects that a program makes itself: instance, device, queue, a compute shader, an image and readback buffers.
// Glift only says which device features and extensions it needs.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// Throws std::runtime_error, which names the call, if `result` says that it failed.
void check(VkResult result, const char* call);

/// The Vulkan device, with a queue for compute and graphics: a discrete GPU if there is one, else the first device.
class PlainVulkan {
public:
    PlainVulkan();
    ~PlainVulkan();
    PlainVulkan(const PlainVulkan&) = delete;
    PlainVulkan& operator=(const PlainVulkan&) = delete;

    VkCommandBuffer begin() const;
    void run(VkCommandBuffer commands) const;  ///< ends, submits and waits

    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    std::uint32_t queue_family = 0;
    std::vector<const char*> extensions;  ///< extensions that the device was made with
    std::string name;

private:
    void choose_device();
    void make_device();

    VkCommandPool pool_ = VK_NULL_HANDLE;
};

/// A compute shader with one storage buffer at binding 1 and push constants.
class ComputeShader {
public:
    ComputeShader(const PlainVulkan& vulkan, std::span<const std::uint32_t> spirv, std::uint32_t parameter_bytes);
    ~ComputeShader();
    ComputeShader(const ComputeShader&) = delete;
    ComputeShader& operator=(const ComputeShader&) = delete;

    void bind(const VkDescriptorBufferInfo& buffer) const;
    void dispatch(VkCommandBuffer commands, const void* parameters, std::uint32_t groups_x,
                  std::uint32_t groups_y) const;

private:
    VkDevice device_;
    std::uint32_t parameter_bytes_;
    VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
    VkDescriptorPool pool_ = VK_NULL_HANDLE;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
};

/// An image with one mip level to draw into and to copy from. Its layout is VK_IMAGE_LAYOUT_GENERAL after clear().
class ColourImage {
public:
    ColourImage(const PlainVulkan& vulkan, VkFormat format, VkExtent2D extent);
    ~ColourImage();
    ColourImage(const ColourImage&) = delete;
    ColourImage& operator=(const ColourImage&) = delete;

    void clear(VkCommandBuffer commands, float value) const;
    void copy_to(VkCommandBuffer commands, VkBuffer buffer) const;

    VkImage image = VK_NULL_HANDLE;
    static constexpr VkImageUsageFlags usage =
        VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;

private:
    VkDevice device_;
    VkExtent2D extent_;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
};

/// A buffer that the host reads.
class ReadbackBuffer {
public:
    ReadbackBuffer(const PlainVulkan& vulkan, VkDeviceSize bytes);
    ~ReadbackBuffer();
    ReadbackBuffer(const ReadbackBuffer&) = delete;
    ReadbackBuffer& operator=(const ReadbackBuffer&) = delete;

    VkBuffer buffer = VK_NULL_HANDLE;
    const void* data = nullptr;

private:
    VkDevice device_;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
};
