#include "link.h"

#include "vulkan_device.h"

#include <bit>

namespace glift::detail {

namespace {

constexpr auto handle_type = VK_EXTERNAL_MEMORY_HANDLE_TYPE_HOST_ALLOCATION_BIT_EXT;

/// Memory of the host as a buffer.
class Attached final : public AttachedObject {
public:
    Attached(std::shared_ptr<DeviceObject> device, Context& context, std::span<std::byte> bytes)
        : device_(std::move(device)), context_(context) {
        const VkDeviceSize page = context.host_import_alignment;
        const VkDeviceSize size = (bytes.size() + page - 1) / page * page;
        const VkExternalMemoryBufferCreateInfo external = {
            .sType = VK_STRUCTURE_TYPE_EXTERNAL_MEMORY_BUFFER_CREATE_INFO, .handleTypes = handle_type};
        const VkBufferCreateInfo info = {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                         .pNext = &external,
                                         .size = size,
                                         .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT};
        try {
            context.check(context.vk.vkCreateBuffer(context.device, &info, nullptr, &buffer_), "vkCreateBuffer");
            import(bytes.data(), size, info);
            context.check(context.vk.vkBindBufferMemory(context.device, buffer_, memory_, 0), "vkBindBufferMemory");
        } catch (...) {
            destroy();
            throw;
        }
    }
    ~Attached() override { destroy(); }

    VkBuffer buffer() const { return buffer_; }

private:
    void import(std::byte* bytes, VkDeviceSize size, const VkBufferCreateInfo& buffer) {
        VkMemoryHostPointerPropertiesEXT pointer = {.sType = VK_STRUCTURE_TYPE_MEMORY_HOST_POINTER_PROPERTIES_EXT};
        context_.check(context_.vk.vkGetMemoryHostPointerPropertiesEXT(context_.device, handle_type, bytes, &pointer),
                       "vkGetMemoryHostPointerPropertiesEXT");
        const VkDeviceBufferMemoryRequirements asked = {.sType = VK_STRUCTURE_TYPE_DEVICE_BUFFER_MEMORY_REQUIREMENTS,
                                                        .pCreateInfo = &buffer};
        VkMemoryRequirements2 needs = {.sType = VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2};
        context_.vk.vkGetDeviceBufferMemoryRequirements(context_.device, &asked, &needs);
        const std::uint32_t types = pointer.memoryTypeBits & needs.memoryRequirements.memoryTypeBits;
        if (types == 0) context_.fail(VK_ERROR_INVALID_EXTERNAL_HANDLE, "vkGetMemoryHostPointerPropertiesEXT");
        const VkImportMemoryHostPointerInfoEXT imported = {.sType =
                                                               VK_STRUCTURE_TYPE_IMPORT_MEMORY_HOST_POINTER_INFO_EXT,
                                                           .handleType = handle_type,
                                                           .pHostPointer = bytes};
        const VkMemoryAllocateInfo info = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                           .pNext = &imported,
                                           .allocationSize = size,
                                           .memoryTypeIndex = static_cast<std::uint32_t>(std::countr_zero(types))};
        context_.check(context_.vk.vkAllocateMemory(context_.device, &info, nullptr, &memory_), "vkAllocateMemory");
    }

    void destroy() {
        context_.vk.vkDestroyBuffer(context_.device, buffer_, nullptr);
        context_.vk.vkFreeMemory(context_.device, memory_, nullptr);
    }

    std::shared_ptr<DeviceObject> device_;
    Context& context_;
    VkBuffer buffer_ = VK_NULL_HANDLE;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
};

VkBuffer buffer_of(const AttachedObject& attached) { return static_cast<const Attached&>(attached).buffer(); }

}  // namespace

VulkanLink::VulkanLink(VulkanDevice& device)
    : device_(device), timeline_(device.context(), device.context().transfer_queue),
      pool_(device.context(), device.context().transfer_family) {}

Memory VulkanLink::allocate(const MemoryDescription& description) {
    const std::lock_guard lock(device_.mutex());
    return Memory(device_.new_linked_memory(description));
}

std::shared_ptr<AttachedObject> VulkanLink::attach(std::span<std::byte> bytes) {
    return std::make_shared<Attached>(device_.shared_from_this(), device_.context(), bytes);
}

void VulkanLink::fetch(const Memory& from, AttachedObject& to, std::span<const CopyRegion> regions) {
    copy(vulkan_memory(from).parts.buffer, buffer_of(to), regions);
}

void VulkanLink::put(AttachedObject& from, const Memory& to, std::span<const CopyRegion> regions) {
    copy(buffer_of(from), vulkan_memory(to).parts.buffer, regions);
}

void VulkanLink::copy(VkBuffer from, VkBuffer to, std::span<const CopyRegion> regions) {
    if (regions.empty()) return;
    Context& context = device_.context();
    if (!pool_.reset()) context.fail(VK_ERROR_OUT_OF_DEVICE_MEMORY, "vkResetCommandPool");
    pool_.begin(VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT);
    const VkCommandBuffer commands = pool_.commands();
    std::vector<VkBufferCopy> copies;
    for (const CopyRegion& region : regions) copies.push_back({region.from, region.to, region.bytes});
    context.vk.vkCmdCopyBuffer(commands, from, to, static_cast<std::uint32_t>(copies.size()), copies.data());
    const VkMemoryBarrier2 barrier = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
                                      .srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT,
                                      .srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                      .dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT,
                                      .dstAccessMask = VK_ACCESS_2_HOST_READ_BIT};
    const VkDependencyInfo dependency = {
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &barrier};
    context.vk.vkCmdPipelineBarrier2(commands, &dependency);
    context.check(context.vk.vkEndCommandBuffer(commands), "vkEndCommandBuffer");
    timeline_.poll(timeline_.submit(commands, device_.timeline().now()));
}

}  // namespace glift::detail
