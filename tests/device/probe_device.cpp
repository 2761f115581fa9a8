#include "probe_device.h"

#include <volk.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace probe {

namespace {

void check(VkResult result, const char* what) {
    if (result == VK_SUCCESS) return;
    std::fprintf(stderr, "%s: VkResult %d\n", what, static_cast<int>(result));
    std::exit(1);
}

struct Buffer {
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    std::uint32_t* data = nullptr;
};

}  // namespace

struct Machine::Parts {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    std::uint32_t family = 0;
    VkCommandPool pool = VK_NULL_HANDLE;
    VkDescriptorSetLayout set_layout = VK_NULL_HANDLE;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    VkDescriptorPool descriptors = VK_NULL_HANDLE;

    void choose(const std::string& name);
    void open();
    void make_layouts();
    Buffer make_buffer(std::size_t words) const;
    VkPipeline make_pipeline(const std::vector<std::uint32_t>& spirv, std::uint32_t operation) const;
    VkDescriptorSet make_set(const std::array<Buffer, 4>& buffers) const;
    void submit(VkPipeline pipeline, VkDescriptorSet set, std::uint32_t count) const;
};

void Machine::Parts::choose(const std::string& name) {
    std::uint32_t count = 0;
    vkEnumeratePhysicalDevices(instance, &count, nullptr);
    std::vector<VkPhysicalDevice> all(count);
    vkEnumeratePhysicalDevices(instance, &count, all.data());
    VkPhysicalDeviceVulkan12Properties more{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_PROPERTIES};
    for (VkPhysicalDevice candidate : all) {
        VkPhysicalDeviceProperties2 properties{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, .pNext = &more};
        vkGetPhysicalDeviceProperties2(candidate, &properties);
        std::printf("device: %s (Vulkan %u.%u.%u, driver %s %s)\n", properties.properties.deviceName, VK_API_VERSION_MAJOR(properties.properties.apiVersion),
                    VK_API_VERSION_MINOR(properties.properties.apiVersion), VK_API_VERSION_PATCH(properties.properties.apiVersion), more.driverName, more.driverInfo);
        std::printf("  float32: denorm preserve %u, flush %u, round to even %u, signed zero inf nan preserve %u; float64: preserve %u, to even %u\n",
                    more.shaderDenormPreserveFloat32, more.shaderDenormFlushToZeroFloat32, more.shaderRoundingModeRTEFloat32,
                    more.shaderSignedZeroInfNanPreserveFloat32, more.shaderDenormPreserveFloat64, more.shaderRoundingModeRTEFloat64);
        if (physical == VK_NULL_HANDLE && std::strstr(properties.properties.deviceName, name.c_str())) {
            physical = candidate;
            std::printf("  chosen\n");
        }
    }
    if (physical == VK_NULL_HANDLE) {
        std::fprintf(stderr, "no Vulkan device has '%s' in its name\n", name.c_str());
        std::exit(1);
    }
}

void Machine::Parts::open() {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    while (family < count && !(families[family].queueFlags & VK_QUEUE_COMPUTE_BIT)) ++family;
    float priority = 1;
    VkDeviceQueueCreateInfo queues{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, .queueFamilyIndex = family, .queueCount = 1, .pQueuePriorities = &priority};
    VkPhysicalDeviceVulkan12Features features{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES, .scalarBlockLayout = VK_TRUE};
    VkPhysicalDeviceFeatures2 core{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, .pNext = &features};
    core.features.shaderFloat64 = VK_TRUE;
    VkDeviceCreateInfo info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, .pNext = &core, .queueCreateInfoCount = 1, .pQueueCreateInfos = &queues};
    check(vkCreateDevice(physical, &info, nullptr, &device), "vkCreateDevice");
    volkLoadDevice(device);
    vkGetDeviceQueue(device, family, 0, &queue);
    VkCommandPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, .queueFamilyIndex = family};
    check(vkCreateCommandPool(device, &pool_info, nullptr, &pool), "vkCreateCommandPool");
}

void Machine::Parts::make_layouts() {
    std::array<VkDescriptorSetLayoutBinding, 4> bindings{};
    for (std::uint32_t i = 0; i < 4; ++i) bindings[i] = {i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
    VkDescriptorSetLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, .bindingCount = 4, .pBindings = bindings.data()};
    check(vkCreateDescriptorSetLayout(device, &info, nullptr, &set_layout), "vkCreateDescriptorSetLayout");
    VkPushConstantRange range{VK_SHADER_STAGE_COMPUTE_BIT, 0, 4};
    VkPipelineLayoutCreateInfo layout_info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO, .setLayoutCount = 1, .pSetLayouts = &set_layout,
                                           .pushConstantRangeCount = 1, .pPushConstantRanges = &range};
    check(vkCreatePipelineLayout(device, &layout_info, nullptr, &layout), "vkCreatePipelineLayout");
    VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 4};
    VkDescriptorPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO, .maxSets = 1, .poolSizeCount = 1, .pPoolSizes = &size};
    check(vkCreateDescriptorPool(device, &pool_info, nullptr, &descriptors), "vkCreateDescriptorPool");
}

Buffer Machine::Parts::make_buffer(std::size_t words) const {
    Buffer made;
    VkBufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = words * 4, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT};
    check(vkCreateBuffer(device, &info, nullptr, &made.buffer), "vkCreateBuffer");
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(device, made.buffer, &needs);
    VkPhysicalDeviceMemoryProperties memories;
    vkGetPhysicalDeviceMemoryProperties(physical, &memories);
    const VkMemoryPropertyFlags wanted = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    std::uint32_t type = 0;
    while (type < memories.memoryTypeCount && !((needs.memoryTypeBits >> type & 1u) && (memories.memoryTypes[type].propertyFlags & wanted) == wanted)) ++type;
    VkMemoryAllocateInfo allocation{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, .allocationSize = needs.size, .memoryTypeIndex = type};
    check(vkAllocateMemory(device, &allocation, nullptr, &made.memory), "vkAllocateMemory");
    check(vkBindBufferMemory(device, made.buffer, made.memory, 0), "vkBindBufferMemory");
    void* data = nullptr;
    check(vkMapMemory(device, made.memory, 0, VK_WHOLE_SIZE, 0, &data), "vkMapMemory");
    made.data = static_cast<std::uint32_t*>(data);
    return made;
}

VkPipeline Machine::Parts::make_pipeline(const std::vector<std::uint32_t>& spirv, std::uint32_t operation) const {
    VkShaderModuleCreateInfo module_info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, .codeSize = spirv.size() * 4, .pCode = spirv.data()};
    VkShaderModule module = VK_NULL_HANDLE;
    check(vkCreateShaderModule(device, &module_info, nullptr, &module), "vkCreateShaderModule");
    VkSpecializationMapEntry entry{0, 0, 4};
    VkSpecializationInfo specialization{1, &entry, 4, &operation};
    VkComputePipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO, .layout = layout};
    info.stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO, .stage = VK_SHADER_STAGE_COMPUTE_BIT, .module = module, .pName = "main",
                  .pSpecializationInfo = &specialization};
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline), "vkCreateComputePipelines");
    vkDestroyShaderModule(device, module, nullptr);
    return pipeline;
}

VkDescriptorSet Machine::Parts::make_set(const std::array<Buffer, 4>& buffers) const {
    check(vkResetDescriptorPool(device, descriptors, 0), "vkResetDescriptorPool");
    VkDescriptorSetAllocateInfo allocation{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO, .descriptorPool = descriptors, .descriptorSetCount = 1,
                                           .pSetLayouts = &set_layout};
    VkDescriptorSet set = VK_NULL_HANDLE;
    check(vkAllocateDescriptorSets(device, &allocation, &set), "vkAllocateDescriptorSets");
    std::array<VkDescriptorBufferInfo, 4> infos{};
    std::array<VkWriteDescriptorSet, 4> writes{};
    for (std::uint32_t i = 0; i < 4; ++i) {
        infos[i] = {buffers[i].buffer, 0, VK_WHOLE_SIZE};
        writes[i] = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET, .dstSet = set, .dstBinding = i, .descriptorCount = 1,
                     .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .pBufferInfo = &infos[i]};
    }
    vkUpdateDescriptorSets(device, 4, writes.data(), 0, nullptr);
    return set;
}

void Machine::Parts::submit(VkPipeline pipeline, VkDescriptorSet set, std::uint32_t count) const {
    check(vkResetCommandPool(device, pool, 0), "vkResetCommandPool");
    VkCommandBufferAllocateInfo allocation{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, .commandPool = pool, .commandBufferCount = 1};
    VkCommandBuffer commands = VK_NULL_HANDLE;
    check(vkAllocateCommandBuffers(device, &allocation, &commands), "vkAllocateCommandBuffers");
    VkCommandBufferBeginInfo begin{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &set, 0, nullptr);
    vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, 4, &count);
    vkCmdDispatch(commands, (count + 63) / 64, 1, 1);
    VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, VK_ACCESS_SHADER_WRITE_BIT, VK_ACCESS_HOST_READ_BIT};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier, 0, nullptr, 0, nullptr);
    check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
    VkSubmitInfo info{.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands};
    check(vkQueueSubmit(queue, 1, &info, VK_NULL_HANDLE), "vkQueueSubmit");
    check(vkQueueWaitIdle(queue), "vkQueueWaitIdle");
    vkFreeCommandBuffers(device, pool, 1, &commands);
}

Machine::Machine(const std::string& name) : parts_(std::make_unique<Parts>()) {
    check(volkInitialize(), "no Vulkan loader (libvulkan.so.1)");
    VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .pApplicationName = "glift_probe_exact", .apiVersion = VK_API_VERSION_1_3};
    VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO, .pApplicationInfo = &application};
    check(vkCreateInstance(&info, nullptr, &parts_->instance), "vkCreateInstance");
    volkLoadInstance(parts_->instance);
    parts_->choose(name);
    parts_->open();
    parts_->make_layouts();
}

Machine::~Machine() {
    vkDestroyDescriptorPool(parts_->device, parts_->descriptors, nullptr);
    vkDestroyPipelineLayout(parts_->device, parts_->layout, nullptr);
    vkDestroyDescriptorSetLayout(parts_->device, parts_->set_layout, nullptr);
    vkDestroyCommandPool(parts_->device, parts_->pool, nullptr);
    vkDestroyDevice(parts_->device, nullptr);
    vkDestroyInstance(parts_->instance, nullptr);
}

std::vector<std::uint32_t> Machine::run(const std::vector<std::uint32_t>& spirv, std::uint32_t operation,
                                        const std::vector<std::vector<std::uint32_t>>& inputs) {
    const std::size_t count = inputs[0].size();
    std::array<Buffer, 4> buffers;
    for (Buffer& buffer : buffers) buffer = parts_->make_buffer(count);
    for (std::size_t i = 0; i < 3; ++i) std::memcpy(buffers[i].data, inputs[i].data(), count * 4);
    VkPipeline pipeline = parts_->make_pipeline(spirv, operation);
    parts_->submit(pipeline, parts_->make_set(buffers), static_cast<std::uint32_t>(count));
    std::vector<std::uint32_t> result(buffers[3].data, buffers[3].data + count);
    vkDestroyPipeline(parts_->device, pipeline, nullptr);
    for (Buffer& buffer : buffers) {
        vkDestroyBuffer(parts_->device, buffer.buffer, nullptr);
        vkFreeMemory(parts_->device, buffer.memory, nullptr);
    }
    return result;
}

}  // namespace probe
