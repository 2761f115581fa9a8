#include "subgroup_sizes.h"

namespace glift::detail {

SubgroupSizes::SubgroupSizes(const Instance& instance, VkPhysicalDevice physical) {
    VkPhysicalDeviceVulkan13Properties v13 = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_PROPERTIES};
    VkPhysicalDeviceVulkan11Properties v11 = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES,
                                              .pNext = &v13};
    VkPhysicalDeviceProperties2 all = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, .pNext = &v11};
    instance.vk().vkGetPhysicalDeviceProperties2(physical, &all);
    size = v11.subgroupSize;
    least = v13.minSubgroupSize;
    greatest = v13.maxSubgroupSize;
    most_in_workgroup = v13.maxComputeWorkgroupSubgroups;
    can_require = (v13.requiredSubgroupSizeStages & VK_SHADER_STAGE_COMPUTE_BIT) != 0;
}

}  // namespace glift::detail
