#include "context.h"

#include "select.h"

#include <glift/error.h>

#include <algorithm>
#include <optional>
#include <tuple>

namespace glift::detail {

namespace {

std::uint32_t choose_queue_family(const Instance& instance, VkPhysicalDevice physical) {
    const auto families = queue_families(instance, physical);
    for (const VkQueueFlags wanted :
         {VkQueueFlags(VK_QUEUE_COMPUTE_BIT | VK_QUEUE_GRAPHICS_BIT), VkQueueFlags(VK_QUEUE_COMPUTE_BIT)}) {
        for (std::uint32_t k = 0; k < families.size(); ++k) {
            if ((families[k].queueFlags & wanted) == wanted) return k;
        }
    }
    throw Error(ErrorCode::missing_feature, "the device has no queue that can compute", "Device::open", {},
                "choose another device with GLIFT_DEVICE=lavapipe or GLIFT_DEVICE=host");
}

/// The family of queues that only copy.
std::optional<std::uint32_t> find_transfer_family(const Instance& instance, VkPhysicalDevice physical) {
    const auto families = queue_families(instance, physical);
    for (std::uint32_t k = 0; k < families.size(); ++k)
        if ((families[k].queueFlags & ~VkQueueFlags(VK_QUEUE_SPARSE_BINDING_BIT)) == VK_QUEUE_TRANSFER_BIT) return k;
    return std::nullopt;
}

[[noreturn]] void refuse_adoption(std::string why, std::string remedy) {
    throw Error(ErrorCode::wrong_argument, "these Vulkan objects cannot be adopted", "glift::vulkan::adopt",
                std::move(why), std::move(remedy));
}

void check_objects(const Context::Adopted& objects) {
    if (!objects.instance || !objects.physical || !objects.device || !objects.queue) {
        refuse_adoption("one of the handles is null", "pass instance, physical device, device and queue");
    }
}

void check_queue_family(const Instance& instance, const Context::Adopted& objects) {
    const auto families = queue_families(instance, objects.physical);
    if (objects.queue_family >= families.size() ||
        !(families[objects.queue_family].queueFlags & VK_QUEUE_COMPUTE_BIT)) {
        refuse_adoption("queue family " + std::to_string(objects.queue_family) + " does not exist or cannot compute",
                        "pass a queue of a family with VK_QUEUE_COMPUTE_BIT");
    }
}

/// The largest buffer that can be bound from several allocations.
std::uint64_t max_sparse_bytes(const Instance& instance, VkPhysicalDevice physical) {
    VkPhysicalDeviceMaintenance4Properties maintenance4 = {
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_4_PROPERTIES};
    VkPhysicalDeviceProperties2 all = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, .pNext = &maintenance4};
    instance.vk().vkGetPhysicalDeviceProperties2(physical, &all);
    return std::min<std::uint64_t>(maintenance4.maxBufferSize, all.properties.limits.sparseAddressSpaceSize);
}

}  // namespace

std::unique_ptr<Context> Context::open(std::string_view which, const Wanted& wanted) {
    std::unique_ptr<Context> context(new Context);
    context->instance = Instance::create(wanted.instance);
    context->owned = true;
    context->physical = select_physical_device(*context->instance, which, wanted.device);
    context->queue_family = choose_queue_family(*context->instance, context->physical);
    const FeatureChain features(*context->instance, context->physical);
    features.require();
    context->set_extensions(features.extensions, wanted.device);
    context->make_device(features);
    context->read_limits(features);
    return context;
}

std::unique_ptr<Context> Context::adopt(const Adopted& objects) {
    check_objects(objects);
    std::unique_ptr<Context> context(new Context);
    context->instance = Instance::adopt(objects.instance, objects.entry);
    context->physical = objects.physical;
    context->device = objects.device;
    context->queue = objects.queue;
    context->queue_family = objects.queue_family;
    context->set_extensions(objects.extensions);
    context->shares_queue = true;
    const FeatureChain features(*context->instance, context->physical);
    features.require();
    check_queue_family(*context->instance, objects);
    context->vk = load_device_table(context->instance->vk(), context->device);
    context->read_limits(features);
    if (context->properties.push_descriptors && !context->vk.vkCmdPushDescriptorSetWithTemplateKHR) {
        refuse_adoption("the device was made without " VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME ", which is named",
                        "name the extensions of VkDeviceCreateInfo::ppEnabledExtensionNames and no others");
    }
    return context;
}

void Context::set_extensions(std::span<const char* const> own, std::span<const std::string> wanted) {
    names_.assign(own.begin(), own.end());
    names_.insert(names_.end(), wanted.begin(), wanted.end());
    for (const std::string& name : names_) extensions.push_back(name.c_str());
}

void Context::make_device(const FeatureChain& features) {
    const float priority = 1;
    VkDeviceQueueCreateInfo queues[2] = {{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                          .queueFamilyIndex = queue_family,
                                          .queueCount = 1,
                                          .pQueuePriorities = &priority}};
    const std::optional<std::uint32_t> transfer = find_transfer_family(*instance, physical);
    queues[1] = queues[0];
    queues[1].queueFamilyIndex = transfer_family = transfer.value_or(0);
    const VkDeviceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                     .pNext = &features.core,
                                     .queueCreateInfoCount = transfer ? 2u : 1u,
                                     .pQueueCreateInfos = queues,
                                     .enabledExtensionCount = static_cast<std::uint32_t>(extensions.size()),
                                     .ppEnabledExtensionNames = extensions.data()};
    check(instance->vk().vkCreateDevice(physical, &info, nullptr, &device), "vkCreateDevice");
    vk = load_device_table(instance->vk(), device);
    vk.vkGetDeviceQueue(device, queue_family, 0, &queue);
    if (transfer) vk.vkGetDeviceQueue(device, transfer_family, 0, &transfer_queue);
}

void Context::read_limits(const FeatureChain& features) {
    subgroups = SubgroupSizes(*instance, physical);
    properties = read_properties(*instance, physical, features, extensions, subgroups);
    core = features.properties;
    instance->vk().vkGetPhysicalDeviceMemoryProperties(physical, &memory);
    const VkQueueFamilyProperties family = queue_families(*instance, physical)[queue_family];
    timestamp_bits = family.timestampValidBits;
    has_labels = is_looked_at();
    can_draw = (family.queueFlags & VK_QUEUE_GRAPHICS_BIT) != 0;
    max_piece_bytes = properties.max_allocation_bytes;
    // Of an adopted device it is not known whether the feature sparseBinding was enabled.
    const bool is_sparse =
        owned && features.core.features.sparseBinding && (family.queueFlags & VK_QUEUE_SPARSE_BINDING_BIT) != 0;
    if (is_sparse) properties.max_allocation_bytes = max_sparse_bytes(*instance, physical);
    VkPhysicalDeviceVulkan12Properties v12 = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_PROPERTIES};
    VkPhysicalDeviceProperties2 floats = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, .pNext = &v12};
    instance->vk().vkGetPhysicalDeviceProperties2(physical, &floats);
    float_controls = FloatControls::of(v12);
    hides_loop_ends = v12.driverID == VK_DRIVER_ID_NVIDIA_PROPRIETARY;
    separates_texels = v12.driverID == VK_DRIVER_ID_NVIDIA_PROPRIETARY;
    if (vk.vkGetMemoryHostPointerPropertiesEXT) {
        VkPhysicalDeviceExternalMemoryHostPropertiesEXT host = {
            .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_EXTERNAL_MEMORY_HOST_PROPERTIES_EXT};
        VkPhysicalDeviceProperties2 all = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, .pNext = &host};
        instance->vk().vkGetPhysicalDeviceProperties2(physical, &all);
        host_import_alignment = host.minImportedHostPointerAlignment;
    }
    if (!properties.push_descriptors) return;
    VkPhysicalDevicePushDescriptorPropertiesKHR push = {
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PUSH_DESCRIPTOR_PROPERTIES_KHR};
    VkPhysicalDeviceProperties2 all = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, .pNext = &push};
    instance->vk().vkGetPhysicalDeviceProperties2(physical, &all);
    max_push_descriptors = push.maxPushDescriptors;
}

/// Whether a tool that may show labels is active: drivers and layers list themselves. Without one labels would cost
/// some hundred nanoseconds a pass, and nobody would see them.
bool Context::is_looked_at() const {
    const InstanceTable& all = instance->vk();
    if (!all.vkCmdBeginDebugUtilsLabelEXT || !all.vkCmdEndDebugUtilsLabelEXT) return false;
    // Old layers, such as the validation layer of Debian 12, know the extension's function only.
    using List = Function<PFN_vkGetPhysicalDeviceToolProperties>;
    const List of_extension(instance->entry()(instance->handle(), "vkGetPhysicalDeviceToolPropertiesEXT"));
    for (const List& list : {all.vkGetPhysicalDeviceToolProperties, of_extension}) {
        std::uint32_t tools = 0;
        if (list && list(physical, &tools, nullptr) == VK_SUCCESS && tools != 0) return true;
    }
    return false;
}

DrawLimits Context::draw_limits() const {
    const VkPhysicalDeviceLimits& limits = core.limits;
    DrawLimits result;
    for (unsigned axis = 0; axis < 2; ++axis) {
        result.viewport[axis] = std::min(result.viewport[axis], limits.maxViewportDimensions[axis]);
        // A viewport may lie anywhere in a target, so a target must also end within the bounds of viewports.
        const float far = limits.viewportBoundsRange[1];
        const auto end = far < 4294967040.0f ? static_cast<std::uint32_t>(far) : UINT32_MAX;
        result.target[axis] = std::min(axis == 0 ? limits.maxFramebufferWidth : limits.maxFramebufferHeight, end);
    }
    result.colours = std::min(limits.maxColorAttachments, limits.maxFragmentOutputAttachments);
    return result;
}

Context::~Context() {
    if (owned && device) vk.vkDestroyDevice(device, nullptr);
}

void Context::fail(VkResult result, const char* call) {
    if (result == VK_ERROR_DEVICE_LOST) {
        lost = true;
        throw Error(ErrorCode::device_lost, "the device was lost", std::string(call) + ", " + properties.name,
                    "the driver stopped it: a kernel ran too long or touched memory that is not its own, or the "
                    "machine took the device away",
                    "open the device anew and make the structures again; run with GLIFT_VALIDATE=1 or a checked build "
                    "(gliftc --checked) to find an access out of range");
    }
    if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY) {
        throw Error(ErrorCode::out_of_memory, "the device has no memory left",
                    std::string(call) + ", " + properties.name, result_text(result),
                    "free structures that are no longer used, or make them smaller");
    }
    throw Error(ErrorCode::vulkan, "a Vulkan call failed", std::string(call) + ", " + properties.name,
                result_text(result), "run with GLIFT_VALIDATE=1 to see what was wrong with it");
}

void Context::set_name(VkObjectType type, std::uint64_t handle, const char* name) const {
    if (!instance->vk().vkSetDebugUtilsObjectNameEXT || !*name) return;
    const VkDebugUtilsObjectNameInfoEXT info = {.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT,
                                                .objectType = type,
                                                .objectHandle = handle,
                                                .pObjectName = name};
    std::ignore = instance->vk().vkSetDebugUtilsObjectNameEXT(device, &info);  // a missing debug name is harmless
}

}  // namespace glift::detail
