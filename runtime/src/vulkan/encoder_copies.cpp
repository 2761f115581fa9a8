// Fills and copies.
#include "../image_layout.h"
#include "encoder.h"
#include "vulkan_device.h"

#include <algorithm>
#include <cstring>

namespace glift::detail {

namespace {

/// The subresource of one mip level and face. If the memory is a part of an image, `mip` and `face` count from the
/// part's first.
VkImageSubresourceLayers subresource(const VulkanMemory& image, std::uint32_t mip, std::uint32_t face) {
    const Texels& part = image.texels();
    return {vulkan_aspect(image.description().format), part.mip + mip, part.layer + face, 1};
}

VkImageSubresourceRange all_of(const VulkanMemory& image) {
    const MemoryDescription& d = image.description();
    return {vulkan_aspect(d.format), image.texels().mip, d.mips, image.texels().layer, face_count(d)};
}

VkBufferImageCopy image_copy(const VulkanMemory& image, const ImageRegion& region, VkDeviceSize buffer_offset) {
    return {.bufferOffset = buffer_offset,
            .imageSubresource = subresource(image, region.mip, region.face),
            .imageOffset = {static_cast<std::int32_t>(region.origin[0]), static_cast<std::int32_t>(region.origin[1]),
                            static_cast<std::int32_t>(region.origin[2])},
            .imageExtent = {region.extent[0], region.extent[1], region.extent[2]}};
}

bool empty(const ImageRegion& region) { return !region.extent[0] || !region.extent[1] || !region.extent[2]; }

std::vector<VkBufferImageCopy> image_copies(const VulkanMemory& image, std::span<const ImageRegion> regions,
                                            VkDeviceSize base) {
    std::vector<VkBufferImageCopy> result;
    for (const ImageRegion& region : regions) {
        if (!empty(region)) result.push_back(image_copy(image, region, base + region.offset));
    }
    return result;
}

/// The most bytes of one copy between buffers, or of one vkCmdFillBuffer. Larger ones are split, since some drivers
/// count bytes in 32 bits. Uploads to buffers arrive in smaller parts already (vulkan_stream.cpp).
constexpr std::uint64_t most_at_once = std::uint64_t(1) << 30;

std::vector<VkBufferCopy> buffer_copies(std::span<const CopyRegion> regions, VkDeviceSize from, VkDeviceSize to) {
    std::vector<VkBufferCopy> result;
    result.reserve(regions.size());
    for (const CopyRegion& region : regions) {
        for (std::uint64_t at = 0; at < region.bytes; at += most_at_once)
            result.push_back({region.from + from + at, region.to + to + at, std::min(most_at_once, region.bytes - at)});
    }
    return result;
}

/// Fills of up to this many bytes are compute dispatches (VulkanDevice::fill_pass): before and after vkCmdFillBuffer an
/// H200 waits for all work. Larger fills use vkCmdFillBuffer, which reaches the memory's bandwidth at that size, unless
/// they are under conditions (Encoder::fill_where).
constexpr std::uint64_t most_filled_by_pass = 1u << 20;

std::uint32_t count(const auto& list) { return static_cast<std::uint32_t>(list.size()); }

VkOffset3D offset3d(const std::array<std::uint32_t, 3>& at) {
    return {static_cast<std::int32_t>(at[0]), static_cast<std::int32_t>(at[1]), static_cast<std::int32_t>(at[2])};
}

}  // namespace

void Encoder::touch(const VulkanMemory& memory, Access access) {
    if (hazards_.conflicts(memory.id, access)) barrier();
    hazards_.note(memory.id, access);
    ++batch_->operations;
}

void Encoder::touch(const VulkanMemory& from, const VulkanMemory& to) {
    if (hazards_.conflicts(from.id, Access::read) || hazards_.conflicts(to.id, Access::write)) barrier();
    hazards_.note(from.id, Access::read);
    hazards_.note(to.id, Access::write);
    ++batch_->operations;
}

void Encoder::fill(const VulkanMemory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value) {
    if (bytes == 0) return;
    touch(memory, Access::write);
    if (bytes > most_filled_by_pass) return fill_in_parts(memory, offset, bytes, value);
    const FillArguments arguments = {memory.address + offset, static_cast<std::uint32_t>(bytes / 4), value};
    device_.fill_pass().bind(commands_, &arguments);
    bound_ = VK_NULL_HANDLE;
    context_.vk.vkCmdDispatch(commands_, (arguments.words + 255) / 256, 1, 1);
}

void Encoder::fill_in_parts(const VulkanMemory& memory, std::uint64_t offset, std::uint64_t bytes,
                            std::uint32_t value) {
    for (std::uint64_t at = 0; at < bytes; at += most_at_once)
        context_.vk.vkCmdFillBuffer(commands_, memory.parts.buffer, offset + at, std::min(most_at_once, bytes - at),
                                    value);
}

void Encoder::clear_new(const VulkanMemory& memory) {
    const MemoryDescription& d = memory.description();
    if (memory.is_buffer()) {
        if (d.zeroed) clear(memory);
        return;
    }
    ++batch_->operations;
    const VkImageSubresourceRange all = all_of(memory);
    // The storage may have belonged to a freed memory: wait for its last accesses.
    const VkImageMemoryBarrier2 first = {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
                                         .srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                         .srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT,
                                         .dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                         .dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT,
                                         .oldLayout = VK_IMAGE_LAYOUT_UNDEFINED,
                                         .newLayout = VK_IMAGE_LAYOUT_GENERAL,
                                         .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                         .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                         .image = memory.parts.image,
                                         .subresourceRange = all};
    const VkDependencyInfo info = {
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .imageMemoryBarrierCount = 1, .pImageMemoryBarriers = &first};
    context_.vk.vkCmdPipelineBarrier2(commands_, &info);
    if (!d.zeroed) return;
    hazards_.note(memory.id, Access::write);
    clear_image(memory);
}

void Encoder::clear(const VulkanMemory& memory) {
    if (memory.is_buffer()) return fill(memory, 0, (memory.description().bytes + 3) / 4 * 4, 0);
    touch(memory, Access::write);
    clear_image(memory);
}

void Encoder::clear_image(const VulkanMemory& memory) {
    memory.require(VK_IMAGE_USAGE_TRANSFER_DST_BIT);
    const MemoryDescription& d = memory.description();
    const VkImageSubresourceRange all = all_of(memory);
    if (d.format == Format::d32) {
        const VkClearDepthStencilValue zero = {};
        context_.vk.vkCmdClearDepthStencilImage(commands_, memory.parts.image, VK_IMAGE_LAYOUT_GENERAL, &zero, 1, &all);
    } else {
        const VkClearColorValue zero = {};
        context_.vk.vkCmdClearColorImage(commands_, memory.parts.image, VK_IMAGE_LAYOUT_GENERAL, &zero, 1, &all);
    }
}

void Encoder::copy(const VulkanMemory& from, const VulkanMemory& to, std::span<const CopyRegion> regions) {
    const auto copies = buffer_copies(regions, 0, 0);
    if (copies.empty()) return;
    touch(from, to);
    context_.vk.vkCmdCopyBuffer(commands_, from.parts.buffer, to.parts.buffer, count(copies), copies.data());
}

void Encoder::copy_to_image(const VulkanMemory& buffer, const VulkanMemory& image,
                            std::span<const ImageRegion> regions) {
    image.require(VK_IMAGE_USAGE_TRANSFER_DST_BIT);
    const auto copies = image_copies(image, regions, 0);
    if (copies.empty()) return;
    touch(buffer, image);
    context_.vk.vkCmdCopyBufferToImage(commands_, buffer.parts.buffer, image.parts.image, VK_IMAGE_LAYOUT_GENERAL,
                                       count(copies), copies.data());
}

void Encoder::copy_from_image(const VulkanMemory& image, const VulkanMemory& buffer,
                              std::span<const ImageRegion> regions) {
    image.require(VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
    const auto copies = image_copies(image, regions, 0);
    if (copies.empty()) return;
    touch(image, buffer);
    context_.vk.vkCmdCopyImageToBuffer(commands_, image.parts.image, VK_IMAGE_LAYOUT_GENERAL, buffer.parts.buffer,
                                       count(copies), copies.data());
}

void Encoder::copy_images(const VulkanMemory& from, const VulkanMemory& to, std::span<const ImageCopyRegion> regions) {
    from.require(VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
    to.require(VK_IMAGE_USAGE_TRANSFER_DST_BIT);
    std::vector<VkImageCopy> copies;
    for (const ImageCopyRegion& r : regions) {
        if (!r.extent[0] || !r.extent[1] || !r.extent[2]) continue;
        copies.push_back({subresource(from, r.from_mip, r.from_face),
                          offset3d(r.from),
                          subresource(to, r.to_mip, r.to_face),
                          offset3d(r.to),
                          {r.extent[0], r.extent[1], r.extent[2]}});
    }
    if (copies.empty()) return;
    touch(from, to);
    context_.vk.vkCmdCopyImage(commands_, from.parts.image, VK_IMAGE_LAYOUT_GENERAL, to.parts.image,
                               VK_IMAGE_LAYOUT_GENERAL, count(copies), copies.data());
}

// Packs the regions into one slice of staging.
void Encoder::upload(const VulkanMemory& to, std::span<const CopyRegion> regions, const std::byte* bytes) {
    std::uint64_t total = 0;
    for (const CopyRegion& region : regions) total += region.bytes;
    if (!total) return;
    const Slice staging = batch_->upload.take(total);
    std::vector<VkBufferCopy> copies;
    copies.reserve(regions.size());
    std::uint64_t at = 0;
    for (const CopyRegion& region : regions) {
        if (!region.bytes) continue;
        std::memcpy(staging.data + at, bytes + region.from, region.bytes);
        copies.push_back({staging.offset + at, region.to, region.bytes});
        at += region.bytes;
    }
    touch(to, Access::write);
    context_.vk.vkCmdCopyBuffer(commands_, staging.buffer(), to.parts.buffer, count(copies), copies.data());
}

void Encoder::upload_filled(const VulkanMemory& to, std::uint64_t bytes, const Stream::Fill& fill) {
    const Slice staging = batch_->upload.take(bytes);
    fill({staging.data, bytes});
    const VkBufferCopy copy = {staging.offset, 0, bytes};
    touch(to, Access::write);
    context_.vk.vkCmdCopyBuffer(commands_, staging.buffer(), to.parts.buffer, 1, &copy);
}

void Encoder::upload_image(const VulkanMemory& image, std::span<const ImageRegion> regions, const std::byte* bytes) {
    image.require(VK_IMAGE_USAGE_TRANSFER_DST_BIT);
    const MemoryDescription& d = image.description();
    const auto packed = [&](const ImageRegion& r) {
        return std::uint64_t(r.extent[0]) * r.extent[1] * r.extent[2] * texel_bytes(d.format);
    };
    constexpr std::uint64_t alignment = 16;  // a multiple of every texel's size, and of 4
    std::uint64_t total = 0;
    for (const ImageRegion& region : regions) total += (packed(region) + alignment - 1) / alignment * alignment;
    if (!total) return;
    const Slice staging = batch_->upload.take(total);
    std::vector<VkBufferImageCopy> copies;
    std::uint64_t at = 0;
    for (const ImageRegion& region : regions) {
        if (empty(region)) continue;
        std::memcpy(staging.data + at, bytes + region.offset, packed(region));
        copies.push_back(image_copy(image, region, staging.offset + at));
        at += (packed(region) + alignment - 1) / alignment * alignment;
    }
    touch(image, Access::write);
    context_.vk.vkCmdCopyBufferToImage(commands_, staging.buffer(), image.parts.image, VK_IMAGE_LAYOUT_GENERAL,
                                       count(copies), copies.data());
}

Slice Encoder::download(const VulkanMemory& from, std::span<const CopyRegion> regions, std::uint64_t bytes) {
    const Slice staging = batch_->readback.take(std::max<std::uint64_t>(bytes, 4));
    const auto copies = buffer_copies(regions, 0, staging.offset);
    if (copies.empty()) return staging;
    touch(from, Access::read);
    context_.vk.vkCmdCopyBuffer(commands_, from.parts.buffer, staging.buffer(), count(copies), copies.data());
    return staging;
}

Slice Encoder::download_image(const VulkanMemory& image, std::span<const ImageRegion> regions, std::uint64_t bytes) {
    image.require(VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
    const Slice staging = batch_->readback.take(std::max<std::uint64_t>(bytes, 4));
    const auto copies = image_copies(image, regions, staging.offset);
    if (copies.empty()) return staging;
    touch(image, Access::read);
    context_.vk.vkCmdCopyImageToBuffer(commands_, image.parts.image, VK_IMAGE_LAYOUT_GENERAL, staging.buffer(),
                                       count(copies), copies.data());
    return staging;
}

void Encoder::timestamp(VkQueryPool pool, std::uint32_t query) {
    ++batch_->operations;
    context_.vk.vkCmdWriteTimestamp2(commands_, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool, query);
}

}  // namespace glift::detail
