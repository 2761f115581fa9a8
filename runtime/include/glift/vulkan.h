// Glift inside a program that has its own Vulkan device. The only public header that includes Vulkan's.
#pragma once

#include <glift/commands.h>
#include <glift/device.h>
#include <glift/memory.h>
#include <glift/vector.h>

#include <vulkan/vulkan.h>

#include <memory>
#include <span>
#include <string_view>

namespace glift::vulkan {

/// The features to make a device with: those of Vulkan 1.0 to 1.3 and of float atomics that this physical device has,
/// without a few that cost speed, that serve capture tools, or that Glift has no use for. Chain `features` (a
/// VkPhysicalDeviceFeatures2 with all the rest behind it) into VkDeviceCreateInfo::pNext, add your own, and enable the
/// extensions.
class GLIFT_API DeviceFeatures {
public:
    /// Throws unsupported_version, missing_feature or no_loader. get_instance_proc_addr: null for the system's loader.
    DeviceFeatures(VkInstance instance, VkPhysicalDevice physical,
                   PFN_vkGetInstanceProcAddr get_instance_proc_addr = nullptr);
    ~DeviceFeatures();
    DeviceFeatures(const DeviceFeatures&) = delete;
    DeviceFeatures& operator=(const DeviceFeatures&) = delete;

    VkPhysicalDeviceFeatures2& features();
    std::span<const char* const> extensions() const;

private:
    struct Chain;
    std::unique_ptr<Chain> chain_;
};

/// Vulkan objects of the user's program, which must outlive the Device and everything made from it. The queue's family
/// must support compute, for draws also graphics. Glift uses the queue only inside its calls, during which no other
/// thread may use it. Needed on instance and device: Vulkan 1.3 (VkApplicationInfo::apiVersion); on the device
/// scalarBlockLayout, timelineSemaphore, bufferDeviceAddress, synchronization2, hostQueryReset, maintenance4,
/// subgroupSizeControl, computeFullSubgroups; for draws also dynamicRendering and shaderTerminateInvocation.
struct Objects {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    std::uint32_t queue_family = 0;
    std::span<const char* const> extensions = {};                ///< enabled on the device; names are copied
    PFN_vkGetInstanceProcAddr get_instance_proc_addr = nullptr;  ///< null: the system's loader
};

/// A device over the user's Vulkan device. Throws unsupported_version, missing_feature, no_loader, wrong_argument.
/// Vulkan does not tell which features a VkDevice was made with: the physical device's are queried, and assumed to have
/// been enabled (DeviceFeatures), except for sparse binding, which is not used.
GLIFT_API Device adopt(const Objects& objects);

/// Extensions to enable beside those that Glift uses itself; the names are copied. A program that opens a window needs
/// those of the window's surface (glfwGetRequiredInstanceExtensions), and VK_KHR_swapchain on the device.
struct Extensions {
    std::span<const char*const> instance = {}, device = {};
};

/// Opens a device as Device::open does, on an instance and a device with these extensions. For programs that use the
/// queue of `objects(device)` themselves. Throws what Device::open does, missing_feature also where no driver has one
/// of the instance extensions or the device lacks one of the device extensions, and wrong_argument for `host`, which
/// has no Vulkan.
GLIFT_API Device open(const Extensions& extensions, std::string_view which = {});

/// Records into the user's command buffer, which is in the recording state, outside of a rendering scope. A barrier
/// against everything earlier on the queue comes first; `finish` records a barrier that makes the results visible to
/// everything later. Both functions submit the device's own pending commands, among them those that zero new memories:
/// submit the command buffer after `finish`. The returned Commands holds memories and parameters: keep it until the
/// command buffer has run. download, timestamp, flush and wait throw wrong_argument there. So does record_into for the
/// host device or a null command buffer, and finish for commands that are not from record_into.
///
/// Bound pipelines, descriptor sets, push constants, viewport and scissor are undefined after each command of Glift:
/// set them again before commands of your own. These may be recorded between two commands of Glift, if they touch no
/// memory that Glift's commands before or after them write; else call `finish` before them and record_into after them.
GLIFT_API Commands record_into(const Device& device, VkCommandBuffer commands);
GLIFT_API void finish(const Commands& commands);

struct BufferHandle {
    VkBuffer buffer;
    VkDeviceSize offset, bytes;  ///< offset: 0; bytes: the memory's size, rounded up to a multiple of 16, at least 16
    VkDeviceAddress address;
};

struct ImageHandle {
    VkImage image;
    VkImageView view;  ///< of all the memory's mips and layers, for sampling; null: an adopted image whose usage has no
                       ///< sampling
    VkFormat format;
    VkImageLayout layout;  ///< always VK_IMAGE_LAYOUT_GENERAL
};

/// The Vulkan objects of a memory, for descriptors of the user's own. Call flush() before commands of the user's use
/// the memory, and keep the memory (or its structure) until these have run: Glift knows of its own commands only, and
/// destroys the objects when those are done. Throws wrong_argument for a memory of the host device, and for an image in
/// place of a buffer or a buffer in place of an image.
GLIFT_API BufferHandle buffer(const Memory& memory);
GLIFT_API ImageHandle image(const Memory& memory);

/// An image of the user's, made on this device: two-dimensional, not multisampled. It must outlive the Memory and
/// everything recorded with it.
struct UserImage {
    VkImage image = VK_NULL_HANDLE;
    VkFormat format = VK_FORMAT_UNDEFINED;  ///< that of one of Glift's formats (host/memory.h)
    uint2 extent;
    std::uint32_t mips = 1, layers = 1;  ///< one layer: image2d, more: image2darray
    VkImageUsageFlags usage = 0;         ///< that the image was made with: what Glift may do with it
    VkImageCreateFlags flags = 0;        ///< that the image was made with
    const char* name = "image";          ///< in errors; copied
};

/// A memory over the user's image, which a structure is made with in place of its own: `Film(device, extent, memory)`.
/// What is drawn or written to the structure then goes into the image. The image has to be in VK_IMAGE_LAYOUT_GENERAL
/// whenever commands of Glift that use it run, and is left in it; its texels stay what they are until commands write
/// them. Commands throw missing_feature where the usage lacks what they need. Throws wrong_argument for the host
/// device, a null image, an extent without texels, more mips than the extent has, or a format that Glift does not have.
GLIFT_API Memory adopt_image(const Device& device, const UserImage& image);

/// The Vulkan objects of a device, opened or adopted; `extensions` live as long as the device. A program may use the
/// queue between calls of Glift: what Glift submits is ordered after what the program submitted before, and what the
/// program submits later after Glift's. The first call for a device that Glift opened submits what Glift has pending,
/// and may throw as flush does. Throws wrong_argument for the host device.
GLIFT_API Objects objects(const Device& device);

}  // namespace glift::vulkan
