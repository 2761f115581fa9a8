// A program's own Vulkan objects, created without Glift (but with the features that it needs), and a loader whose
// results a test can change.
#pragma once

#include "test_device.h"

#include <glift/vulkan.h>

#include <memory>
#include <vector>

/// Faults that the loader injects, and calls that it counted. Reset at the start of each test.
struct Pretence {
    bool vulkan_1_2 = false;
    bool no_timeline = false;
    bool lost = false;  ///< the next submission and every wait
    bool no_memory = false;
    bool no_shuffles = false;          ///< subgroups do not exchange values, nor reduce 64-bit ones
    bool no_push_descriptors = false;  ///< the device was made without the extension

    std::uint64_t calls = 0;         ///< of the device's functions that can fail
    std::uint64_t failing_call = 0;  ///< counted from 1, which fails with `failure`; 0: none
    VkResult failure = VK_ERROR_OUT_OF_HOST_MEMORY;
    const char* failed = "";  ///< its name

    std::uint64_t submissions = 0;      ///< of the device
    std::uint64_t command_buffers = 0;  ///< in them
};
extern Pretence pretence;
PFN_vkVoidFunction VKAPI_CALL pretending_loader(VkInstance instance, const char* name);

class PlainVulkan {
public:
    PlainVulkan();
    ~PlainVulkan();
    void destroy_device();  ///< before the rest

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
