// Which features and extensions Glift needs and uses.
#pragma once

#include "instance.h"
#include "subgroup_sizes.h"

#include <glift/device.h>

#include <span>
#include <string>
#include <vector>

namespace glift::detail {

/// The features of Vulkan 1.0 to 1.3 and of float atomics that the physical device offers, without a few that Glift
/// does not want (features.cpp), chained and ready for VkDeviceCreateInfo; the extensions that Glift uses.
struct FeatureChain {
    FeatureChain(const Instance& instance, VkPhysicalDevice physical);
    FeatureChain(const FeatureChain&) = delete;

    VkPhysicalDeviceProperties properties;
    std::vector<const char*> extensions;
    VkPhysicalDeviceFeatures2 core = {};
    VkPhysicalDeviceVulkan11Features v11 = {};
    VkPhysicalDeviceVulkan12Features v12 = {};
    VkPhysicalDeviceVulkan13Features v13 = {};
    VkPhysicalDeviceShaderAtomicFloatFeaturesEXT atomic_float = {};
    VkPhysicalDeviceShaderAtomicFloat2FeaturesEXT atomic_float2 = {};

    /// Whether the device's Vulkan is older than 1.3. Then only `properties` is filled in; nothing else is queried.
    bool old() const { return properties.apiVersion < VK_API_VERSION_1_3; }
    std::string missing() const;  ///< names of required features that are absent, empty if none
    void require() const;         ///< throws unsupported_version or missing_feature
};

/// The names of the wanted extensions that the physical device lacks; empty if none.
std::string lacking_extensions(const Instance& instance, VkPhysicalDevice physical,
                               std::span<const std::string> wanted);

/// Properties of a physical device; `extensions` are those that the device is made with. Where it is uncertain which
/// size subgroups have, there are none of their operations, and their size is 1.
DeviceProperties read_properties(const Instance& instance, VkPhysicalDevice physical, const FeatureChain& features,
                                 const std::vector<const char*>& extensions, const SubgroupSizes& subgroups);

}  // namespace glift::detail
