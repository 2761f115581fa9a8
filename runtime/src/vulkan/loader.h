// Vulkan's functions, loaded at run time: the loader's, those of an instance, those of a device.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <string>
#include <vector>

namespace glift::detail {

/// A Vulkan function. Compilers warn where a VkResult is ignored.
template <class Pointer> class Function;

template <class Result, class... Parameters> class Function<Result(VKAPI_PTR*)(Parameters...)> {
public:
    Function() = default;
    explicit Function(PFN_vkVoidFunction found)
        : pointer_(reinterpret_cast<Result(VKAPI_PTR*)(Parameters...)>(found)) {}

    Result operator()(Parameters... parameters) const { return pointer_(parameters...); }
    explicit operator bool() const { return pointer_ != nullptr; }

private:
    Result(VKAPI_PTR* pointer_)(Parameters...) = nullptr;
};

template <class... Parameters> class Function<VkResult(VKAPI_PTR*)(Parameters...)> {
public:
    Function() = default;
    explicit Function(PFN_vkVoidFunction found)
        : pointer_(reinterpret_cast<VkResult(VKAPI_PTR*)(Parameters...)>(found)) {}

    [[nodiscard]] VkResult operator()(Parameters... parameters) const { return pointer_(parameters...); }
    explicit operator bool() const { return pointer_ != nullptr; }

private:
    VkResult(VKAPI_PTR* pointer_)(Parameters...) = nullptr;
};

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
    X(vkGetDeviceProcAddr)

// Those of extensions, null where the extension is not enabled, and one that old layers lack.
#define GLIFT_INSTANCE_EXTENSION_FUNCTIONS(X) \
    X(vkCreateDebugUtilsMessengerEXT) \
    X(vkDestroyDebugUtilsMessengerEXT) \
    X(vkSetDebugUtilsObjectNameEXT) \
    X(vkCmdBeginDebugUtilsLabelEXT) \
    X(vkCmdEndDebugUtilsLabelEXT) \
    X(vkGetPhysicalDeviceToolProperties)

#define GLIFT_DEVICE_FUNCTIONS(X) \
    X(vkAllocateCommandBuffers) \
    X(vkAllocateDescriptorSets) \
    X(vkAllocateMemory) \
    X(vkBeginCommandBuffer) \
    X(vkBindBufferMemory) \
    X(vkBindImageMemory) \
    X(vkCmdBeginRendering) \
    X(vkCmdBindDescriptorSets) \
    X(vkCmdBindPipeline) \
    X(vkCmdClearColorImage) \
    X(vkCmdClearDepthStencilImage) \
    X(vkCmdCopyBuffer) \
    X(vkCmdCopyBufferToImage) \
    X(vkCmdCopyImage) \
    X(vkCmdCopyImageToBuffer) \
    X(vkCmdDispatch) \
    X(vkCmdDispatchBase) \
    X(vkCmdDispatchIndirect) \
    X(vkCmdDraw) \
    X(vkCmdDrawIndirect) \
    X(vkCmdEndRendering) \
    X(vkCmdFillBuffer) \
    X(vkCmdPipelineBarrier2) \
    X(vkCmdPushConstants) \
    X(vkCmdResetQueryPool) \
    X(vkCmdSetScissor) \
    X(vkCmdSetViewport) \
    X(vkCmdWriteTimestamp2) \
    X(vkCreateBuffer) \
    X(vkCreateCommandPool) \
    X(vkCreateComputePipelines) \
    X(vkCreateDescriptorPool) \
    X(vkCreateDescriptorSetLayout) \
    X(vkCreateDescriptorUpdateTemplate) \
    X(vkCreateFence) \
    X(vkCreateGraphicsPipelines) \
    X(vkCreateImage) \
    X(vkCreateImageView) \
    X(vkCreatePipelineCache) \
    X(vkCreatePipelineLayout) \
    X(vkCreateQueryPool) \
    X(vkCreateSampler) \
    X(vkCreateSemaphore) \
    X(vkCreateShaderModule) \
    X(vkDestroyBuffer) \
    X(vkDestroyCommandPool) \
    X(vkDestroyDescriptorPool) \
    X(vkDestroyDescriptorSetLayout) \
    X(vkDestroyDescriptorUpdateTemplate) \
    X(vkDestroyDevice) \
    X(vkDestroyFence) \
    X(vkDestroyImage) \
    X(vkDestroyImageView) \
    X(vkDestroyPipeline) \
    X(vkDestroyPipelineCache) \
    X(vkDestroyPipelineLayout) \
    X(vkDestroyQueryPool) \
    X(vkDestroySampler) \
    X(vkDestroySemaphore) \
    X(vkDestroyShaderModule) \
    X(vkEndCommandBuffer) \
    X(vkFreeMemory) \
    X(vkGetBufferDeviceAddress) \
    X(vkGetBufferMemoryRequirements) \
    X(vkGetDeviceBufferMemoryRequirements) \
    X(vkGetDeviceImageMemoryRequirements) \
    X(vkGetDeviceQueue) \
    X(vkGetPipelineCacheData) \
    X(vkGetQueryPoolResults) \
    X(vkGetSemaphoreCounterValue) \
    X(vkMapMemory) \
    X(vkQueueBindSparse) \
    X(vkQueueSubmit2) \
    X(vkQueueWaitIdle) \
    X(vkResetCommandPool) \
    X(vkResetDescriptorPool) \
    X(vkResetQueryPool) \
    X(vkUpdateDescriptorSetWithTemplate) \
    X(vkWaitForFences) \
    X(vkSignalSemaphore) \
    X(vkWaitSemaphores)

#define GLIFT_DEVICE_EXTENSION_FUNCTIONS(X) \
    X(vkCmdPushDescriptorSetWithTemplateKHR) \
    X(vkGetCalibratedTimestampsEXT) \
    X(vkGetMemoryHostPointerPropertiesEXT)
// clang-format on

struct InstanceTable {
#define GLIFT_DECLARE(name) Function<PFN_##name> name;
    GLIFT_INSTANCE_FUNCTIONS(GLIFT_DECLARE)
    GLIFT_INSTANCE_EXTENSION_FUNCTIONS(GLIFT_DECLARE)
};

struct DeviceTable {
    GLIFT_DEVICE_FUNCTIONS(GLIFT_DECLARE)
    GLIFT_DEVICE_EXTENSION_FUNCTIONS(GLIFT_DECLARE)
#undef GLIFT_DECLARE
};

/// The entry point of the system's loader, or of the library that GLIFT_VULKAN_LOADER names. Throws no_loader.
PFN_vkGetInstanceProcAddr load_vulkan();

/// These throw unsupported_version if a function of Vulkan 1.3 is not there.
InstanceTable load_instance_table(PFN_vkGetInstanceProcAddr get, VkInstance instance);
DeviceTable load_device_table(const InstanceTable& instance, VkDevice device);

std::string result_text(VkResult result);

/// Throws out_of_memory or vulkan if the call failed. For calls that have no device yet.
void check_result(VkResult result, const char* call);

/// All values that `query(count, values)` enumerates. Their number may change between the two calls; if it has grown,
/// both calls are repeated.
template <class Value, class Query> std::vector<Value> listed(const char* call, Query query) {
    for (;;) {
        std::uint32_t count = 0;
        check_result(query(&count, nullptr), call);
        std::vector<Value> values(count);
        const VkResult result = query(&count, values.data());
        if (result == VK_INCOMPLETE) continue;
        check_result(result, call);
        values.resize(count);
        return values;
    }
}

}  // namespace glift::detail
