// A program's own Vulkan objects, created without Glift (but with the features that it needs), and a loader of Vulkan
// functions whose results a test can change.
#pragma once

#include "test_device.h"

#include <glift/vulkan.h>

#include <memory>
#include <vector>

/// Faults that the loader injects, and calls that it counts. The constructor of PlainVulkan resets it.
struct Pretence {
    bool vulkan_1_2 = false;
    bool no_features = false;  ///< of Vulkan 1.2 and 1.3
    bool lost = false;         ///< every vkQueueSubmit2 and every vkWaitSemaphores fails, if failing_call is 0
    bool no_memory = false;
    bool no_shuffles = false;          ///< subgroups support no shuffles and no 64-bit reductions
    bool no_push_descriptors = false;  ///< the device has no functions of VK_KHR_push_descriptor

    std::uint32_t largest_viewport = 0, largest_framebuffer = 0, most_colours = 0;  ///< limits; 0: the device's own

    bool sizes_vary = false;        ///< subgroups have half the device's lanes to twice as many; a size can be required
    bool no_required_size = false;  ///< with sizes_vary: none can
    std::uint32_t most_subgroups = 0;                  ///< of a workgroup; 0: the device's own
    VkPipelineShaderStageCreateFlags stage_flags = 0;  ///< of the compute pipeline that was made last
    std::uint32_t required_size = 0;                   ///< of its subgroups; 0: none

    std::uint64_t calls = 0;         ///< calls of the functions listed in plain_vulkan.cpp, if failing_call is not 0
    std::uint64_t failing_call = 0;  ///< number, from 1, of the call that fails with `failure`; 0: none
    VkResult failure = VK_ERROR_OUT_OF_HOST_MEMORY;
    const char* failed = "";  ///< name of the function that failed

    bool notes_labels = false;  ///< labels and names are noted, and the tools are these
    std::uint32_t tools = 0;
    std::vector<std::string> labels;  ///< `begin NAME`, `end`
    std::vector<std::string> names;   ///< of objects

    std::uint64_t submissions = 0;      ///< submissions to the device, if failing_call is 0
    std::uint64_t command_buffers = 0;  ///< command buffers in them
};
extern Pretence pretence;
PFN_vkVoidFunction VKAPI_CALL pretending_loader(VkInstance instance, const char* name);

class PlainVulkan {
public:
    explicit PlainVulkan(std::uint32_t api_version = VK_API_VERSION_1_3);
    ~PlainVulkan();
    void destroy_device();  ///< for tests that destroy the device before the other objects

    glift::vulkan::Objects objects() const { return {instance, physical, device, queue, 0, extensions, nullptr}; }
    VkCommandBuffer begin() const;
    void run(VkCommandBuffer commands) const;  ///< ends, submits and waits

    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    VkCommandPool pool = VK_NULL_HANDLE;
    std::vector<const char*> extensions;
};
