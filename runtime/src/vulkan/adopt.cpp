// The functions of glift/vulkan.h.
#include "../check.h"
#include "../profile/process_profile.h"
#include "../text.h"
#include "vulkan_device.h"

#include <glift/error.h>

// Includes <vulkan/vulkan.h>, which declares types here but no functions (VK_NO_PROTOTYPES).
#include <glift/vulkan.h>

#include <cstdlib>

namespace glift::vulkan {

namespace {

std::shared_ptr<detail::VulkanDevice> vulkan_device(const std::shared_ptr<detail::DeviceObject>& object,
                                                    const char* call) {
    auto device = std::dynamic_pointer_cast<detail::VulkanDevice>(object);
    if (!device) {
        throw Error(ErrorCode::wrong_argument, "the host device has no Vulkan objects", call, {},
                    "open a Vulkan device, or adopt your own with glift::vulkan::adopt");
    }
    return device;
}

detail::VulkanMemory& memory_of(const Memory& memory, MemoryKind kind, const char* call) {
    if (!memory) detail::throw_empty_handle((std::string("Memory, ") + call).c_str());
    vulkan_device(memory.object()->device(), call);
    const bool wants_buffer = kind == MemoryKind::buffer;
    if (wants_buffer != (memory.description().kind == MemoryKind::buffer)) {
        throw Error(ErrorCode::wrong_argument, "a memory of the wrong kind was passed", call,
                    detail::memory_text(memory.description()),
                    wants_buffer ? "ask for glift::vulkan::image" : "ask for glift::vulkan::buffer");
    }
    return detail::vulkan_memory(memory);
}

}  // namespace

struct DeviceFeatures::Chain {
    Chain(VkInstance handle, VkPhysicalDevice physical, PFN_vkGetInstanceProcAddr get)
        : instance(detail::Instance::adopt(handle, get)), features(*instance, physical) {
        features.require();
    }
    std::unique_ptr<detail::Instance> instance;
    detail::FeatureChain features;
};

DeviceFeatures::DeviceFeatures(VkInstance instance, VkPhysicalDevice physical,
                               PFN_vkGetInstanceProcAddr get_instance_proc_addr)
    : chain_(std::make_unique<Chain>(instance, physical, get_instance_proc_addr)) {}
DeviceFeatures::~DeviceFeatures() = default;

VkPhysicalDeviceFeatures2& DeviceFeatures::features() { return chain_->features.core; }
std::span<const char* const> DeviceFeatures::extensions() const { return chain_->features.extensions; }

Device adopt(const Objects& objects) {
    auto context = detail::Context::adopt({objects.instance,
                                           objects.physical,
                                           objects.device,
                                           objects.queue,
                                           objects.queue_family,
                                           {objects.extensions.begin(), objects.extensions.end()},
                                           objects.get_instance_proc_addr});
    const Device device(std::make_shared<detail::VulkanDevice>(std::move(context)));
    detail::profile_if_asked(device.share());
    return device;
}

Device open(const Extensions& extensions, std::string_view which) {
    if (which.empty()) {
        if (const char* wanted = std::getenv("GLIFT_DEVICE")) which = wanted;
    }
    if (which == "host") {
        throw Error(ErrorCode::wrong_argument, "the host device has no Vulkan extensions", "glift::vulkan::open", {},
                    "choose a Vulkan device, with GLIFT_DEVICE=lavapipe for example");
    }
    const Device device(detail::open_vulkan_device(which, {{extensions.instance.begin(), extensions.instance.end()},
                                                           {extensions.device.begin(), extensions.device.end()}}));
    detail::profile_if_asked(device.share());
    return device;
}

Commands record_into(const Device& device, VkCommandBuffer commands) {
    constexpr const char* call = "glift::vulkan::record_into";
    const auto object = vulkan_device(detail::shared_device(device, "Device, glift::vulkan::record_into"), call);
    if (!commands) {
        throw Error(ErrorCode::wrong_argument, "a null command buffer was passed", call, {},
                    "pass a command buffer in the recording state");
    }
    return Commands(std::make_shared<detail::ExternalStream>(object, commands));
}

void finish(const Commands& commands) {
    if (!commands) detail::throw_empty_handle("Commands, glift::vulkan::finish");
    auto* stream = dynamic_cast<detail::ExternalStream*>(commands.share().get());
    if (!stream) {
        throw Error(ErrorCode::wrong_argument, "these commands are not from record_into", "glift::vulkan::finish", {},
                    "pass what glift::vulkan::record_into returned; a recording finishes by itself");
    }
    stream->finish();
}

BufferHandle buffer(const Memory& memory) {
    const detail::VulkanMemory& object = memory_of(memory, MemoryKind::buffer, "glift::vulkan::buffer");
    return {object.parts.buffer, 0, object.range, object.address};
}

ImageHandle image(const Memory& memory) {
    const detail::VulkanMemory& object = memory_of(memory, MemoryKind::image2d, "glift::vulkan::image");
    return {object.parts.image, object.parts.sampled_view, detail::vulkan_format(memory.description().format),
            VK_IMAGE_LAYOUT_GENERAL};
}

namespace {

[[noreturn]] void refuse_image(const UserImage& image, std::string why, std::string remedy) {
    throw Error(ErrorCode::wrong_argument, "this image cannot be adopted",
                std::string("glift::vulkan::adopt_image, ") + image.name, std::move(why), std::move(remedy));
}

Format format_of(const UserImage& image) {
    for (std::uint8_t i = 1; i <= static_cast<std::uint8_t>(Format::d32); ++i)
        if (detail::vulkan_format(static_cast<Format>(i)) == image.format) return static_cast<Format>(i);
    refuse_image(image, "Glift has no texel format like VkFormat " + std::to_string(image.format),
                 "make it with the format of one of Glift's: VK_FORMAT_R8G8B8A8_UNORM for rgba8, for example");
}

}  // namespace

Memory adopt_image(const Device& device, const UserImage& image) {
    const auto object = vulkan_device(detail::shared_device(device, "Device, glift::vulkan::adopt_image"),
                                      "glift::vulkan::adopt_image");
    if (!image.image) refuse_image(image, "the handle is null", "pass the VkImage");
    if (!image.extent.x || !image.extent.y || !image.mips || !image.layers)
        refuse_image(image, "it has no texels", "name its extent, levels and layers");
    const MemoryDescription description =
        detail::whole_description({.name = image.name,
                                   .kind = image.layers == 1 ? MemoryKind::image2d : MemoryKind::image2darray,
                                   .format = format_of(image),
                                   .extent = {image.extent.x, image.extent.y, image.layers},
                                   .mips = image.mips});
    const std::lock_guard lock(object->mutex());
    return Memory(object->adopted_image(description, image.image, image.usage, image.flags));
}

Objects objects(const Device& device) {
    const auto object =
        vulkan_device(detail::shared_device(device, "Device, glift::vulkan::objects"), "glift::vulkan::objects");
    const std::lock_guard lock(object->mutex());
    object->share_queue();
    const detail::Context& context = object->context();
    return {context.instance->handle(), context.physical,   context.device,           context.queue,
            context.queue_family,       context.extensions, context.instance->entry()};
}

}  // namespace glift::vulkan
