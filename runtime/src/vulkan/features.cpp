#include "features.h"

#include <glift/error.h>

#include <algorithm>
#include <cstring>
#include <string_view>

namespace glift::detail {

namespace {

bool contains(const std::vector<const char*>& names, const char* name) {
    return std::any_of(names.begin(), names.end(), [&](const char* n) { return std::strcmp(n, name) == 0; });
}

class PresentExtensions {
public:
    PresentExtensions(const Instance& instance, VkPhysicalDevice physical)
        : all_(listed<VkExtensionProperties>(
              "vkEnumerateDeviceExtensionProperties", [&](std::uint32_t* count, VkExtensionProperties* values) {
                  return instance.vk().vkEnumerateDeviceExtensionProperties(physical, nullptr, count, values);
              })) {}
    bool has(const char* name) const {
        return std::any_of(all_.begin(), all_.end(),
                           [&](const VkExtensionProperties& e) { return std::strcmp(e.extensionName, name) == 0; });
    }

private:
    std::vector<VkExtensionProperties> all_;
};

std::vector<const char*> usable_extensions(const Instance& instance, VkPhysicalDevice physical) {
    const PresentExtensions present(instance, physical);
    std::vector<const char*> result;
    for (const char* wanted : {VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME, VK_EXT_SHADER_ATOMIC_FLOAT_EXTENSION_NAME,
                               VK_EXT_SHADER_ATOMIC_FLOAT_2_EXTENSION_NAME, VK_EXT_EXTERNAL_MEMORY_HOST_EXTENSION_NAME,
                               VK_EXT_CALIBRATED_TIMESTAMPS_EXTENSION_NAME}) {
        if (present.has(wanted)) result.push_back(wanted);
    }
    return result;
}

// Turns off features that cost speed, serve capture tools, or that Glift has no use for.
void drop_unwanted(FeatureChain& chain) {
    chain.core.features.robustBufferAccess = VK_FALSE;
    chain.v11.protectedMemory = VK_FALSE;
    chain.v12.bufferDeviceAddressCaptureReplay = VK_FALSE;
    chain.v12.bufferDeviceAddressMultiDevice = VK_FALSE;
    chain.v13.robustImageAccess = VK_FALSE;
}

constexpr std::uint64_t lavapipe_loop_rounds = 65535;

}  // namespace

FeatureChain::FeatureChain(const Instance& instance, VkPhysicalDevice physical) {
    core.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    v11.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES;
    v12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    v13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    atomic_float.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SHADER_ATOMIC_FLOAT_FEATURES_EXT;
    atomic_float2.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SHADER_ATOMIC_FLOAT_2_FEATURES_EXT;
    instance.vk().vkGetPhysicalDeviceProperties(physical, &properties);
    if (old()) return;
    extensions = usable_extensions(instance, physical);
    core.pNext = &v11;
    v11.pNext = &v12;
    v12.pNext = &v13;
    void** tail = &v13.pNext;
    if (contains(extensions, VK_EXT_SHADER_ATOMIC_FLOAT_EXTENSION_NAME)) {
        *tail = &atomic_float;
        tail = &atomic_float.pNext;
    }
    if (contains(extensions, VK_EXT_SHADER_ATOMIC_FLOAT_2_EXTENSION_NAME)) *tail = &atomic_float2;
    instance.vk().vkGetPhysicalDeviceFeatures2(physical, &core);
    drop_unwanted(*this);
}

std::string FeatureChain::missing() const {
    std::string names;
    const auto need = [&](VkBool32 present, const char* name) {
        if (!present) names += (names.empty() ? "" : ", ") + std::string(name);
    };
    need(v12.scalarBlockLayout, "scalarBlockLayout");
    need(v12.timelineSemaphore, "timelineSemaphore");
    need(v12.bufferDeviceAddress, "bufferDeviceAddress");
    need(v12.hostQueryReset, "hostQueryReset");
    need(v13.synchronization2, "synchronization2");
    need(v13.maintenance4, "maintenance4");
    need(v13.subgroupSizeControl, "subgroupSizeControl");
    need(v13.computeFullSubgroups, "computeFullSubgroups");
    return names;
}

void FeatureChain::require() const {
    if (old()) {
        throw Error(ErrorCode::unsupported_version, "the device's Vulkan is too old", properties.deviceName,
                    "it supports Vulkan " + std::to_string(VK_API_VERSION_MAJOR(properties.apiVersion)) + "." +
                        std::to_string(VK_API_VERSION_MINOR(properties.apiVersion)) + ", Glift needs 1.3",
                    "update its driver, or choose another device with GLIFT_DEVICE=lavapipe or GLIFT_DEVICE=host");
    }
    const std::string names = missing();
    if (!names.empty()) {
        throw Error(ErrorCode::missing_feature, "the device lacks a feature that Glift needs", properties.deviceName,
                    "missing: " + names,
                    "update its driver, or choose another device with GLIFT_DEVICE=lavapipe or GLIFT_DEVICE=host; a "
                    "program's own instance needs VkApplicationInfo::apiVersion = VK_API_VERSION_1_3");
    }
}

std::string lacking_extensions(const Instance& instance, VkPhysicalDevice physical,
                               std::span<const std::string> wanted) {
    if (wanted.empty()) return {};
    const PresentExtensions present(instance, physical);
    std::string names;
    for (const std::string& name : wanted)
        if (!present.has(name.c_str())) names += (names.empty() ? "" : ", ") + name;
    return names;
}

// long: the function has a line for each property
DeviceProperties read_properties(const Instance& instance, VkPhysicalDevice physical, const FeatureChain& features,
                                 const std::vector<const char*>& extensions, const SubgroupSizes& subgroups) {
    VkPhysicalDeviceMaintenance4Properties maintenance4 = {
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_4_PROPERTIES};
    VkPhysicalDeviceVulkan11Properties v11 = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES,
                                              .pNext = &maintenance4};
    VkPhysicalDeviceVulkan12Properties v12 = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_PROPERTIES,
                                              .pNext = &v11};
    VkPhysicalDeviceProperties2 core = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, .pNext = &v12};
    instance.vk().vkGetPhysicalDeviceProperties2(physical, &core);
    VkPhysicalDeviceMemoryProperties memory;
    instance.vk().vkGetPhysicalDeviceMemoryProperties(physical, &memory);

    const VkPhysicalDeviceLimits& limits = core.properties.limits;
    DeviceProperties p;
    p.name = core.properties.deviceName;
    p.driver = std::string(v12.driverName) + " " + v12.driverInfo;
    p.kind = core.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU ? DeviceKind::cpu : DeviceKind::gpu;
    p.subgroup_size = subgroups.is_certain() ? subgroups.size : 1;
    for (std::uint32_t heap = 0; heap < memory.memoryHeapCount; ++heap) {
        if (memory.memoryHeaps[heap].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) {
            p.memory_bytes = std::max(p.memory_bytes, memory.memoryHeaps[heap].size);
        }
    }
    p.max_allocation_bytes = std::min(v11.maxMemoryAllocationSize, maintenance4.maxBufferSize);
    p.max_storage_buffer_range = limits.maxStorageBufferRange;
    p.shared_memory_bytes = limits.maxComputeSharedMemorySize;
    p.max_push_constant_bytes = limits.maxPushConstantsSize;
    std::copy_n(limits.maxComputeWorkGroupCount, 3, p.max_workgroups.begin());
    std::copy_n(limits.maxComputeWorkGroupSize, 3, p.max_workgroup_size.begin());
    p.max_workgroup_invocations = limits.maxComputeWorkGroupInvocations;
    p.fences_are_barriers = v12.driverID == VK_DRIVER_ID_MESA_LLVMPIPE;
    p.helpers_load = v12.driverID != VK_DRIVER_ID_MESA_LLVMPIPE;
    if (v12.driverID == VK_DRIVER_ID_MESA_LLVMPIPE) p.loop_round_limit = lavapipe_loop_rounds;
    p.timestamp_seconds = limits.timestampPeriod * 1e-9;

    p.int8 = features.v12.shaderInt8 && features.v12.storageBuffer8BitAccess;
    p.int16 = features.core.features.shaderInt16 && features.v11.storageBuffer16BitAccess;
    p.int64 = features.core.features.shaderInt64;
    p.float16 = features.v12.shaderFloat16 && features.v11.storageBuffer16BitAccess;
    p.float64 = features.core.features.shaderFloat64;
    p.int64_atomics = features.v12.shaderBufferInt64Atomics;
    if (contains(extensions, VK_EXT_SHADER_ATOMIC_FLOAT_EXTENSION_NAME)) {
        p.float32_atomic_add =
            features.atomic_float.shaderBufferFloat32AtomicAdd && features.atomic_float.shaderSharedFloat32AtomicAdd;
        p.image_float32_atomic_add = features.atomic_float.shaderImageFloat32AtomicAdd;
    }
    if (contains(extensions, VK_EXT_SHADER_ATOMIC_FLOAT_2_EXTENSION_NAME)) {
        p.float32_atomic_min_max = features.atomic_float2.shaderBufferFloat32AtomicMinMax;
    }
    const auto subgroups_do = [&](VkSubgroupFeatureFlagBits operations) {
        return subgroups.is_certain() && (v11.subgroupSupportedStages & VK_SHADER_STAGE_COMPUTE_BIT) != 0 &&
               (v11.subgroupSupportedOperations & operations) != 0;
    };
    p.subgroup_vote = subgroups_do(VK_SUBGROUP_FEATURE_VOTE_BIT);
    p.subgroup_arithmetic = subgroups_do(VK_SUBGROUP_FEATURE_ARITHMETIC_BIT);
    p.subgroup_ballot = subgroups_do(VK_SUBGROUP_FEATURE_BALLOT_BIT);
    p.subgroup_shuffle = subgroups_do(VK_SUBGROUP_FEATURE_SHUFFLE_BIT);
    p.subgroup_shuffle_relative = subgroups_do(VK_SUBGROUP_FEATURE_SHUFFLE_RELATIVE_BIT);
    p.subgroup_extended_types = subgroups.is_certain() && features.v12.shaderSubgroupExtendedTypes;
    p.descriptor_indexing = features.v12.descriptorIndexing;
    p.push_descriptors = contains(extensions, VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME);
    return p;
}

}  // namespace glift::detail
