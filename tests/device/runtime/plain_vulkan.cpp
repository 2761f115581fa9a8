#include "plain_vulkan.h"

#include <cstring>

Pretence pretence;

namespace {

VKAPI_ATTR void VKAPI_CALL get_properties(VkPhysicalDevice physical, VkPhysicalDeviceProperties* properties) {
    vkGetPhysicalDeviceProperties(physical, properties);
    if (pretence.vulkan_1_2) properties->apiVersion = VK_API_VERSION_1_2;
    VkPhysicalDeviceLimits& limits = properties->limits;
    if (const auto side = pretence.largest_viewport)
        limits.maxViewportDimensions[0] = limits.maxViewportDimensions[1] = side;
    if (const auto side = pretence.largest_framebuffer) limits.maxFramebufferWidth = limits.maxFramebufferHeight = side;
    if (pretence.most_colours) limits.maxColorAttachments = pretence.most_colours;
}

VKAPI_ATTR void VKAPI_CALL get_features(VkPhysicalDevice physical, VkPhysicalDeviceFeatures2* features) {
    vkGetPhysicalDeviceFeatures2(physical, features);
    for (auto* next = static_cast<VkBaseOutStructure*>(features->pNext); next; next = next->pNext) {
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES && pretence.no_features)
            *reinterpret_cast<VkPhysicalDeviceVulkan12Features*>(next) = {.sType = next->sType, .pNext = next->pNext};
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES && pretence.no_features)
            *reinterpret_cast<VkPhysicalDeviceVulkan13Features*>(next) = {.sType = next->sType, .pNext = next->pNext};
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES && pretence.no_shuffles) {
            reinterpret_cast<VkPhysicalDeviceVulkan12Features*>(next)->shaderSubgroupExtendedTypes = VK_FALSE;
        }
    }
}

void pretend_sizes(VkPhysicalDeviceVulkan13Properties& properties) {
    if (pretence.sizes_vary) {
        properties.minSubgroupSize /= 2;
        properties.maxSubgroupSize *= 2;
    }
    if (pretence.no_required_size) properties.requiredSubgroupSizeStages = 0;
    if (pretence.most_subgroups) properties.maxComputeWorkgroupSubgroups = pretence.most_subgroups;
}

VKAPI_ATTR void VKAPI_CALL get_more_properties(VkPhysicalDevice physical, VkPhysicalDeviceProperties2* properties) {
    vkGetPhysicalDeviceProperties2(physical, properties);
    for (auto* next = static_cast<VkBaseOutStructure*>(properties->pNext); next; next = next->pNext) {
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES && pretence.no_shuffles) {
            reinterpret_cast<VkPhysicalDeviceVulkan11Properties*>(next)->subgroupSupportedOperations &=
                ~VkSubgroupFeatureFlags(VK_SUBGROUP_FEATURE_SHUFFLE_BIT | VK_SUBGROUP_FEATURE_SHUFFLE_RELATIVE_BIT);
        }
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_PROPERTIES)
            pretend_sizes(*reinterpret_cast<VkPhysicalDeviceVulkan13Properties*>(next));
    }
}

VKAPI_ATTR VkResult VKAPI_CALL create_compute_pipelines(VkDevice device, VkPipelineCache cache, std::uint32_t count,
                                                        const VkComputePipelineCreateInfo* infos,
                                                        const VkAllocationCallbacks* callbacks, VkPipeline* pipelines) {
    pretence.stage_flags = infos[count - 1].stage.flags;
    pretence.required_size = 0;
    for (auto* next = static_cast<const VkBaseInStructure*>(infos[count - 1].stage.pNext); next; next = next->pNext) {
        if (next->sType == VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_REQUIRED_SUBGROUP_SIZE_CREATE_INFO)
            pretence.required_size = reinterpret_cast<const VkPipelineShaderStageRequiredSubgroupSizeCreateInfo*>(next)
                                         ->requiredSubgroupSize;
    }
    return vkCreateComputePipelines(device, cache, count, infos, callbacks, pipelines);
}

VKAPI_ATTR VkResult VKAPI_CALL submit(VkQueue queue, std::uint32_t count, const VkSubmitInfo2* infos, VkFence fence) {
    pretence.submissions += count;
    for (std::uint32_t k = 0; k < count; ++k) pretence.command_buffers += infos[k].commandBufferInfoCount;
    return pretence.lost ? VK_ERROR_DEVICE_LOST : vkQueueSubmit2(queue, count, infos, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL wait(VkDevice device, const VkSemaphoreWaitInfo* info, std::uint64_t timeout) {
    return pretence.lost ? VK_ERROR_DEVICE_LOST : vkWaitSemaphores(device, info, timeout);
}

VKAPI_ATTR VkResult VKAPI_CALL allocate(VkDevice device, const VkMemoryAllocateInfo* info,
                                        const VkAllocationCallbacks* callbacks, VkDeviceMemory* memory) {
    return pretence.no_memory ? VK_ERROR_OUT_OF_DEVICE_MEMORY : vkAllocateMemory(device, info, callbacks, memory);
}

// The runtime must use vkQueueSubmit2 only, since calls of vkQueueSubmit are not counted: one fails the test.
VKAPI_ATTR VkResult VKAPI_CALL submit_in_the_old_way(VkQueue queue, std::uint32_t count, const VkSubmitInfo* infos,
                                                     VkFence fence) {
    ADD_FAILURE() << "vkQueueSubmit";
    return vkQueueSubmit(queue, count, infos, fence);
}

VKAPI_ATTR void VKAPI_CALL begin_label(VkCommandBuffer, const VkDebugUtilsLabelEXT* label) {
    pretence.labels.push_back(std::string("begin ") + label->pLabelName);
}

VKAPI_ATTR void VKAPI_CALL end_label(VkCommandBuffer) { pretence.labels.push_back("end"); }

VKAPI_ATTR VkResult VKAPI_CALL set_name(VkDevice, const VkDebugUtilsObjectNameInfoEXT* info) {
    pretence.names.push_back(info->pObjectName);
    return VK_SUCCESS;
}

VKAPI_ATTR VkResult VKAPI_CALL list_tools(VkPhysicalDevice, std::uint32_t* count, VkPhysicalDeviceToolProperties*) {
    *count = pretence.tools;
    return VK_SUCCESS;
}

template <class Function> PFN_vkVoidFunction erased(Function function) {
    return reinterpret_cast<PFN_vkVoidFunction>(function);
}

/// Wraps a Vulkan function that can fail, and makes it fail when `pretence` says so.
template <int number, class Pointer> struct Failing;
template <int number, class... Parameters> struct Failing<number, VkResult(VKAPI_PTR*)(Parameters...)> {
    static inline VkResult(VKAPI_PTR* real)(Parameters...) = nullptr;
    static inline const char* name = "";
    static inline VkDevice device = VK_NULL_HANDLE;

    static VKAPI_ATTR VkResult VKAPI_CALL call(Parameters... parameters) {
        if (++pretence.calls != pretence.failing_call) return real(parameters...);
        pretence.failed = name;
        // Waits, since on a device that is really lost no work is left running.
        if (pretence.failure == VK_ERROR_DEVICE_LOST) vkDeviceWaitIdle(device);
        return pretence.failure;
    }
};

PFN_vkVoidFunction failing_function(VkDevice device, const char* name) {
#define FAILING(function)                                                                                              \
    if (!std::strcmp(name, #function)) {                                                                               \
        using Stand = Failing<__COUNTER__, PFN_##function>;                                                            \
        Stand::real = function, Stand::name = #function, Stand::device = device;                                       \
        return erased(Stand::call);                                                                                    \
    }
    FAILING(vkAllocateCommandBuffers)
    FAILING(vkAllocateDescriptorSets)
    FAILING(vkAllocateMemory)
    FAILING(vkBeginCommandBuffer)
    FAILING(vkBindBufferMemory)
    FAILING(vkBindImageMemory)
    FAILING(vkCreateBuffer)
    FAILING(vkCreateCommandPool)
    FAILING(vkCreateComputePipelines)
    FAILING(vkCreateDescriptorPool)
    FAILING(vkCreateDescriptorSetLayout)
    FAILING(vkCreateDescriptorUpdateTemplate)
    FAILING(vkCreateImage)
    FAILING(vkCreateImageView)
    FAILING(vkCreatePipelineCache)
    FAILING(vkCreatePipelineLayout)
    FAILING(vkCreateQueryPool)
    FAILING(vkCreateSampler)
    FAILING(vkCreateSemaphore)
    FAILING(vkCreateShaderModule)
    FAILING(vkEndCommandBuffer)
    FAILING(vkGetPipelineCacheData)
    FAILING(vkGetQueryPoolResults)
    FAILING(vkGetSemaphoreCounterValue)
    FAILING(vkMapMemory)
    FAILING(vkQueueSubmit2)
    FAILING(vkResetCommandPool)
    FAILING(vkResetDescriptorPool)
    FAILING(vkWaitSemaphores)
#undef FAILING
    return nullptr;
}

PFN_vkVoidFunction VKAPI_CALL device_function(VkDevice device, const char* name) {
    if (pretence.failing_call) {
        if (const PFN_vkVoidFunction failing = failing_function(device, name)) return failing;
    }
    if (!std::strcmp(name, "vkQueueSubmit2")) return erased(submit);
    if (!std::strcmp(name, "vkQueueSubmit")) return erased(submit_in_the_old_way);
    if (!std::strcmp(name, "vkWaitSemaphores")) return erased(wait);
    if (!std::strcmp(name, "vkAllocateMemory")) return erased(allocate);
    if (!std::strcmp(name, "vkCreateComputePipelines")) return erased(create_compute_pipelines);
    if (pretence.no_push_descriptors && std::strstr(name, "PushDescriptorSet")) return nullptr;
    return vkGetDeviceProcAddr(device, name);
}

}  // namespace

PFN_vkVoidFunction VKAPI_CALL pretending_loader(VkInstance instance, const char* name) {
    if (!std::strcmp(name, "vkGetPhysicalDeviceProperties")) return erased(get_properties);
    if (!std::strcmp(name, "vkGetPhysicalDeviceProperties2")) return erased(get_more_properties);
    if (!std::strcmp(name, "vkGetPhysicalDeviceFeatures2")) return erased(get_features);
    if (!std::strcmp(name, "vkGetDeviceProcAddr")) return erased(device_function);
    if (pretence.notes_labels) {
        if (!std::strcmp(name, "vkCmdBeginDebugUtilsLabelEXT")) return erased(begin_label);
        if (!std::strcmp(name, "vkCmdEndDebugUtilsLabelEXT")) return erased(end_label);
        if (!std::strcmp(name, "vkSetDebugUtilsObjectNameEXT")) return erased(set_name);
        if (std::strstr(name, "vkGetPhysicalDeviceToolProperties")) return erased(list_tools);
    }
    return vkGetInstanceProcAddr(instance, name);
}

PlainVulkan::PlainVulkan(std::uint32_t api_version) {
    pretence = {};
    const VkApplicationInfo application = {.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .apiVersion = api_version};
    const char* layer = "VK_LAYER_KHRONOS_validation";
    const char* debug = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
    const char* wanted = std::getenv("GLIFT_VALIDATE");
    const bool validate = wanted != nullptr && std::string_view(wanted) == "1";
    const VkValidationFeatureEnableEXT checks[] = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    const VkValidationFeaturesEXT validation = {.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT,
                                                .enabledValidationFeatureCount = 1,
                                                .pEnabledValidationFeatures = checks};
    const VkInstanceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                       .pNext = validate ? &validation : nullptr,
                                       .pApplicationInfo = &application,
                                       .enabledLayerCount = validate ? 1u : 0u,
                                       .ppEnabledLayerNames = &layer,
                                       .enabledExtensionCount = 1,
                                       .ppEnabledExtensionNames = &debug};
    EXPECT_EQ(vkCreateInstance(&info, nullptr, &instance), VK_SUCCESS);
    std::uint32_t count = 1;
    vkEnumeratePhysicalDevices(instance, &count, &physical);

    glift::vulkan::DeviceFeatures features(instance, physical);
    extensions.assign(features.extensions().begin(), features.extensions().end());
    const float priority = 1;
    const VkDeviceQueueCreateInfo queue_info = {
        .sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, .queueCount = 1, .pQueuePriorities = &priority};
    const VkDeviceCreateInfo device_info = {.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                            .pNext = &features.features(),
                                            .queueCreateInfoCount = 1,
                                            .pQueueCreateInfos = &queue_info,
                                            .enabledExtensionCount = static_cast<std::uint32_t>(extensions.size()),
                                            .ppEnabledExtensionNames = extensions.data()};
    EXPECT_EQ(vkCreateDevice(physical, &device_info, nullptr, &device), VK_SUCCESS);
    vkGetDeviceQueue(device, 0, 0, &queue);
    const VkCommandPoolCreateInfo pool_info = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    vkCreateCommandPool(device, &pool_info, nullptr, &pool);
}

void PlainVulkan::destroy_device() {
    if (!device) return;
    vkDestroyCommandPool(device, pool, nullptr);
    vkDestroyDevice(device, nullptr);
    device = VK_NULL_HANDLE;
}

PlainVulkan::~PlainVulkan() {
    destroy_device();
    vkDestroyInstance(instance, nullptr);
}

VkCommandBuffer PlainVulkan::begin() const {
    const VkCommandBufferAllocateInfo info = {
        .sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, .commandPool = pool, .commandBufferCount = 1};
    VkCommandBuffer commands = VK_NULL_HANDLE;
    vkAllocateCommandBuffers(device, &info, &commands);
    const VkCommandBufferBeginInfo begin_info = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    vkBeginCommandBuffer(commands, &begin_info);
    return commands;
}

void PlainVulkan::run(VkCommandBuffer commands) const {
    vkEndCommandBuffer(commands);
    const VkSubmitInfo info = {
        .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands};
    EXPECT_EQ(vkQueueSubmit(queue, 1, &info, VK_NULL_HANDLE), VK_SUCCESS);
    vkQueueWaitIdle(queue);
}
