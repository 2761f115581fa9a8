// Vulkan's functions: the loader, found at run time, and those of an instance. Those of a device are volk's table.
#pragma once

#include <volk.h>

namespace glift::detail {

// clang-format off
#define GLIFT_INSTANCE_FUNCTIONS(X) \
    X(vkDestroyInstance) \
    X(vkEnumeratePhysicalDevices) \
    X(vkGetPhysicalDeviceProperties) \
    X(vkGetPhysicalDeviceProperties2) \
    X(vkGetPhysicalDeviceFeatures2) \
    X(vkGetPhysicalDeviceQueueFamilyProperties) \
    X(vkGetPhysicalDeviceMemoryProperties) \
    X(vkGetPhysicalDeviceImageFormatProperties) \
    X(vkEnumerateDeviceExtensionProperties) \
    X(vkGetPhysicalDeviceFormatProperties) \
    X(vkCreateDevice) \
    X(vkGetDeviceProcAddr) \
    X(vkCreateDebugUtilsMessengerEXT) \
    X(vkDestroyDebugUtilsMessengerEXT) \
    X(vkSetDebugUtilsObjectNameEXT)
// clang-format on

struct InstanceTable {
#define GLIFT_DECLARE(name) PFN_##name name = nullptr;
    GLIFT_INSTANCE_FUNCTIONS(GLIFT_DECLARE)
#undef GLIFT_DECLARE
};

/// The entry point of the system's loader, or of the library that GLIFT_VULKAN_LOADER names. Throws no_loader.
PFN_vkGetInstanceProcAddr load_vulkan();

InstanceTable load_instance_table(PFN_vkGetInstanceProcAddr get, VkInstance instance);
VolkDeviceTable load_device_table(const InstanceTable& instance, VkDevice device);

const char* result_text(VkResult result);

}  // namespace glift::detail
