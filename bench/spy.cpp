#include "spy.h"

#include <glift/vulkan.h>

#include <cstring>
#include <string>

namespace bench {

namespace {

PFN_vkGetInstanceProcAddr system_get = nullptr;
PFN_vkGetDeviceProcAddr device_get = nullptr;
PFN_vkCreateShaderModule create_module = nullptr;
PFN_vkCreateComputePipelines create_pipelines = nullptr;
Shader last;

VKAPI_ATTR VkResult VKAPI_CALL keep_module(VkDevice device, const VkShaderModuleCreateInfo* info,
                                           const VkAllocationCallbacks* with, VkShaderModule* module) {
    last.words.assign(info->pCode, info->pCode + info->codeSize / 4);
    return create_module(device, info, with, module);
}

VKAPI_ATTR VkResult VKAPI_CALL keep_constants(VkDevice device, VkPipelineCache cache, std::uint32_t count,
                                              const VkComputePipelineCreateInfo* info,
                                              const VkAllocationCallbacks* with, VkPipeline* pipelines) {
    last.constants.clear();
    if (const VkSpecializationInfo* values = info->stage.pSpecializationInfo)
        for (std::uint32_t i = 0; i < values->mapEntryCount; ++i) {
            const VkSpecializationMapEntry& entry = values->pMapEntries[i];
            std::uint32_t& value = last.constants[entry.constantID];
            std::memcpy(&value, static_cast<const std::byte*>(values->pData) + entry.offset, sizeof value);
        }
    return create_pipelines(device, cache, count, info, with, pipelines);
}

template <class Function> PFN_vkVoidFunction plain(Function function) {
    return reinterpret_cast<PFN_vkVoidFunction>(function);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL get_of_device(VkDevice device, const char* name) {
    const PFN_vkVoidFunction found = device_get(device, name);
    if (name == std::string("vkCreateShaderModule")) {
        create_module = reinterpret_cast<PFN_vkCreateShaderModule>(found);
        return plain(keep_module);
    }
    if (name == std::string("vkCreateComputePipelines")) {
        create_pipelines = reinterpret_cast<PFN_vkCreateComputePipelines>(found);
        return plain(keep_constants);
    }
    return found;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL get_of_instance(VkInstance instance, const char* name) {
    const PFN_vkVoidFunction found = system_get(instance, name);
    if (name != std::string("vkGetDeviceProcAddr")) return found;
    device_get = reinterpret_cast<PFN_vkGetDeviceProcAddr>(found);
    return plain(get_of_device);
}

}  // namespace

glift::Device spy_on(const glift::Device& device) {
    glift::vulkan::Objects objects = glift::vulkan::objects(device);
    system_get = objects.get_instance_proc_addr;
    objects.get_instance_proc_addr = get_of_instance;
    return glift::vulkan::adopt(objects);
}

Shader last_shader() { return last; }

}  // namespace bench
