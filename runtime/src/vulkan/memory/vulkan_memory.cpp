#include "vulkan_memory.h"

#include "image_layout.h"
#include "sparse_binding.h"
#include "text.h"
#include "vulkan/vulkan_device.h"

#include <glift/error.h>

#include <algorithm>

namespace glift::detail {

namespace {

constexpr VkBufferUsageFlags buffer_usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
                                            VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
                                            VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT |
                                            VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT;

VkImageType image_type(MemoryKind kind) {
    switch (kind) {
    case MemoryKind::image1d: return VK_IMAGE_TYPE_1D;
    case MemoryKind::image3d: return VK_IMAGE_TYPE_3D;
    case MemoryKind::buffer:
    case MemoryKind::image2d:
    case MemoryKind::image2darray:
    case MemoryKind::imagecube: return VK_IMAGE_TYPE_2D;
    }
    return VK_IMAGE_TYPE_2D;
}

VkImageViewType view_type(MemoryKind kind) {
    switch (kind) {
    case MemoryKind::image1d: return VK_IMAGE_VIEW_TYPE_1D;
    case MemoryKind::image3d: return VK_IMAGE_VIEW_TYPE_3D;
    case MemoryKind::imagecube: return VK_IMAGE_VIEW_TYPE_CUBE;
    case MemoryKind::image2darray: return VK_IMAGE_VIEW_TYPE_2D_ARRAY;
    case MemoryKind::buffer:
    case MemoryKind::image2d: return VK_IMAGE_VIEW_TYPE_2D;
    }
    return VK_IMAGE_VIEW_TYPE_2D;
}

/// The format of views of an image of floats as integers of the same bits: for atomic operations that devices have on
/// integers alone.
constexpr VkFormat bits_format = VK_FORMAT_R32_SINT;

bool may_be_bits(Format format) { return format == Format::r32f; }

VkImageView make_view(Context& context, VkImage image, const MemoryDescription& d, VkImageViewType type,
                      const VkImageSubresourceRange& range, VkImageUsageFlags usage,
                      VkFormat format = VK_FORMAT_UNDEFINED) {
    const VkImageViewUsageCreateInfo usage_info = {.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_USAGE_CREATE_INFO,
                                                   .usage = usage};
    const VkImageViewCreateInfo info = {.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                        .pNext = &usage_info,
                                        .image = image,
                                        .viewType = type,
                                        .format = format ? format : vulkan_format(d.format),
                                        .subresourceRange = range};
    VkImageView view = VK_NULL_HANDLE;
    context.check(context.vk.vkCreateImageView(context.device, &info, nullptr, &view), "vkCreateImageView");
    context.set_name(VK_OBJECT_TYPE_IMAGE_VIEW, reinterpret_cast<std::uint64_t>(view), d.name);
    return view;
}

/// Makes the views of an image or of a part of it: of all its levels for sampling, and of the first level as a storage
/// image. A view that the image's usage does not allow is null.
MemoryParts::PartViews made_views(Context& context, const MemoryParts& parts, const MemoryDescription& d,
                                  const Texels& texels) {
    const VkImage image = parts.image;
    const auto range = [&](std::uint32_t mips) {
        return VkImageSubresourceRange{vulkan_aspect(d.format), texels.mip, mips, texels.layer, texels.layers};
    };
    const VkImageViewType type = view_type(d.kind);
    MemoryParts::PartViews views{texels, d.kind, VK_NULL_HANDLE, VK_NULL_HANDLE};
    if (parts.usage & VK_IMAGE_USAGE_SAMPLED_BIT)
        views.sampled_view = make_view(context, image, d, type, range(texels.mips), VK_IMAGE_USAGE_SAMPLED_BIT);
    try {
        if (parts.usage & VK_IMAGE_USAGE_STORAGE_BIT)
            views.storage_view = make_view(context, image, d, type, range(1), VK_IMAGE_USAGE_STORAGE_BIT);
    } catch (...) {
        context.vk.vkDestroyImageView(context.device, views.sampled_view, nullptr);
        throw;
    }
    return views;
}

// The usages that this device allows for an image of this description. Throws missing_feature if it cannot be sampled.
VkImageUsageFlags image_usage(Context& context, const MemoryDescription& d) {
    VkFormatProperties format;
    context.instance->vk().vkGetPhysicalDeviceFormatProperties(context.physical, vulkan_format(d.format), &format);
    VkImageUsageFlags usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    const VkFormatFeatureFlags features = format.optimalTilingFeatures;
    if (features & VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT) usage |= VK_IMAGE_USAGE_SAMPLED_BIT;
    if (features & VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT) usage |= VK_IMAGE_USAGE_STORAGE_BIT;
    const uint2 most = context.draw_limits().target;
    const bool flat = image_type(d.kind) == VK_IMAGE_TYPE_2D && d.extent[0] <= most.x && d.extent[1] <= most.y;
    if (flat && features & VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT) usage |= VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    if (flat && features & VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT) {
        usage |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    }
    if (!(usage & VK_IMAGE_USAGE_SAMPLED_BIT)) {
        throw Error(ErrorCode::missing_feature, "the device cannot read images of this format", memory_text(d),
                    context.properties.name, "use another texel format");
    }
    return usage;
}

VkBufferCreateInfo buffer_info(const VulkanDevice& owner, const MemoryDescription& d) {
    // Rounded up, since shaders may load vectors of four words: the last vector must fit, and one in an empty buffer.
    const VkDeviceSize size = (std::max<VkDeviceSize>(std::min(d.bytes, unlimited - 15), 1) + 15) / 16 * 16;
    if (size > owner.properties().max_allocation_bytes) owner.throw_too_large(d);
    const bool in_pieces = size > owner.max_piece_bytes();
    return {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
            .flags = in_pieces ? VkBufferCreateFlags(VK_BUFFER_CREATE_SPARSE_BINDING_BIT) : 0,
            .size = size,
            .usage = buffer_usage};
}

/// The formats of all views of an r32f image. They are listed so that devices may still compress the image, though it
/// has views of another format.
constexpr std::array view_formats = {VK_FORMAT_R32_SFLOAT, bits_format};
constexpr VkImageFormatListCreateInfo format_list = {.sType = VK_STRUCTURE_TYPE_IMAGE_FORMAT_LIST_CREATE_INFO,
                                                     .viewFormatCount = view_formats.size(),
                                                     .pViewFormats = view_formats.data()};

VkImageCreateInfo image_info(VulkanDevice& owner, const MemoryDescription& d) {
    if (d.bytes > owner.max_piece_bytes()) owner.throw_too_large(d);
    const auto extent = mip_extent(d, 0);
    VkImageCreateFlags flags = 0;
    if (d.kind == MemoryKind::imagecube) flags |= VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT;
    if (may_be_bits(d.format)) flags |= VK_IMAGE_CREATE_MUTABLE_FORMAT_BIT;
    return {.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
            .pNext = may_be_bits(d.format) ? &format_list : nullptr,
            .flags = flags,
            .imageType = image_type(d.kind),
            .format = vulkan_format(d.format),
            .extent = {extent[0], extent[1], extent[2]},
            .mipLevels = d.mips,
            .arrayLayers = face_count(d),
            .samples = VK_SAMPLE_COUNT_1_BIT,
            .tiling = VK_IMAGE_TILING_OPTIMAL,
            .usage = image_usage(owner.context(), d)};
}

void check_image_limits(Context& context, const MemoryDescription& d, const VkImageCreateInfo& info) {
    VkImageFormatProperties limits = {};
    const VkResult result = context.instance->vk().vkGetPhysicalDeviceImageFormatProperties(
        context.physical, info.format, info.imageType, info.tiling, info.usage, info.flags, &limits);
    if (result == VK_ERROR_FORMAT_NOT_SUPPORTED) {
        throw Error(ErrorCode::missing_feature, "the device has no images of this kind and format", memory_text(d),
                    context.properties.name, "use another texel format, or a buffer");
    }
    context.check(result, "vkGetPhysicalDeviceImageFormatProperties");
    const VkExtent3D most = limits.maxExtent;
    if (info.extent.width > most.width || info.extent.height > most.height || info.extent.depth > most.depth ||
        d.mips > limits.maxMipLevels || info.arrayLayers > limits.maxArrayLayers) {
        throw Error(ErrorCode::too_large, "an image is larger than the device allows", memory_text(d),
                    context.properties.name + " allows " + std::to_string(most.width) + " x " +
                        std::to_string(most.height) + " x " + std::to_string(most.depth) + " texels and " +
                        std::to_string(limits.maxArrayLayers) + " layers",
                    "use a smaller one, or a buffer");
    }
}

}  // namespace

VkFormat vulkan_format(Format format) {
    switch (format) {
    case Format::none: return VK_FORMAT_UNDEFINED;
    case Format::r8: return VK_FORMAT_R8_UNORM;
    case Format::rg8: return VK_FORMAT_R8G8_UNORM;
    case Format::rgba8: return VK_FORMAT_R8G8B8A8_UNORM;
    case Format::r16f: return VK_FORMAT_R16_SFLOAT;
    case Format::rg16f: return VK_FORMAT_R16G16_SFLOAT;
    case Format::rgba16f: return VK_FORMAT_R16G16B16A16_SFLOAT;
    case Format::r32f: return VK_FORMAT_R32_SFLOAT;
    case Format::rg32f: return VK_FORMAT_R32G32_SFLOAT;
    case Format::rgba32f: return VK_FORMAT_R32G32B32A32_SFLOAT;
    case Format::r8ui: return VK_FORMAT_R8_UINT;
    case Format::r16ui: return VK_FORMAT_R16_UINT;
    case Format::r32ui: return VK_FORMAT_R32_UINT;
    case Format::rg32ui: return VK_FORMAT_R32G32_UINT;
    case Format::rgba32ui: return VK_FORMAT_R32G32B32A32_UINT;
    case Format::r32i: return VK_FORMAT_R32_SINT;
    case Format::rg32i: return VK_FORMAT_R32G32_SINT;
    case Format::rgba32i: return VK_FORMAT_R32G32B32A32_SINT;
    case Format::rgba8ui: return VK_FORMAT_R8G8B8A8_UINT;
    case Format::d32: return VK_FORMAT_D32_SFLOAT;
    }
    return VK_FORMAT_UNDEFINED;
}

VkImageAspectFlags vulkan_aspect(Format format) {
    return format == Format::d32 ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

VulkanMemory::VulkanMemory(std::shared_ptr<DeviceObject> device, const MemoryDescription& description)
    : MemoryObject(std::move(device), description) {}

VulkanDevice& VulkanMemory::owner() const { return static_cast<VulkanDevice&>(*device()); }

VulkanMemory::VulkanMemory(const std::shared_ptr<VulkanMemory>& whole, const MemoryDescription& description,
                           const Texels& texels)
    : MemoryObject(whole, description, texels), id(whole->id) {
    const MemoryParts::PartViews& views = whole->views_of(description, texels);
    parts.image = whole->parts.image;
    parts.usage = whole->parts.usage;
    parts.sampled_view = views.sampled_view;
    parts.storage_view = views.storage_view;
}

VulkanMemory::~VulkanMemory() {
    if (!whole()) owner().retire(parts, id);
}

std::shared_ptr<MemoryObject> VulkanMemory::part(const MemoryDescription& description, const Texels& texels) {
    const std::lock_guard lock(owner().mutex());
    return std::make_shared<VulkanMemory>(std::static_pointer_cast<VulkanMemory>(shared_from_this()), description,
                                          texels);
}

VkMemoryRequirements VulkanMemory::needs_of(VulkanDevice& owner, const MemoryDescription& d) {
    Context& context = owner.context();
    VkMemoryRequirements2 needs = {.sType = VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2};
    if (d.kind == MemoryKind::buffer) {
        const VkBufferCreateInfo buffer = buffer_info(owner, d);
        const VkDeviceBufferMemoryRequirements info = {.sType = VK_STRUCTURE_TYPE_DEVICE_BUFFER_MEMORY_REQUIREMENTS,
                                                       .pCreateInfo = &buffer};
        context.vk.vkGetDeviceBufferMemoryRequirements(context.device, &info, &needs);
    } else {
        const VkImageCreateInfo image = image_info(owner, d);
        const VkDeviceImageMemoryRequirements info = {.sType = VK_STRUCTURE_TYPE_DEVICE_IMAGE_MEMORY_REQUIREMENTS,
                                                      .pCreateInfo = &image};
        context.vk.vkGetDeviceImageMemoryRequirements(context.device, &info, &needs);
    }
    return needs.memoryRequirements;
}

void VulkanMemory::make(UsedBy users) {
    Context& context = owner().context();
    const MemoryDescription& d = description();
    if (d.kind == MemoryKind::buffer) {
        VkBufferCreateInfo info = buffer_info(owner(), d);
        const std::uint32_t families[] = {context.queue_family, context.transfer_family};
        if (users == UsedBy::all_queues) {
            info.sharingMode = VK_SHARING_MODE_CONCURRENT;
            info.queueFamilyIndexCount = 2;
            info.pQueueFamilyIndices = families;
        }
        range = info.size;
        context.check(context.vk.vkCreateBuffer(context.device, &info, nullptr, &parts.buffer), "vkCreateBuffer");
        context.set_name(VK_OBJECT_TYPE_BUFFER, reinterpret_cast<std::uint64_t>(parts.buffer), d.name);
        return;
    }
    const VkImageCreateInfo info = image_info(owner(), d);
    check_image_limits(context, d, info);
    parts.usage = info.usage;
    context.check(context.vk.vkCreateImage(context.device, &info, nullptr, &parts.image), "vkCreateImage");
    context.set_name(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<std::uint64_t>(parts.image), d.name);
}

void VulkanMemory::bind(VkDeviceMemory memory, VkDeviceSize offset) {
    Context& context = owner().context();
    if (is_buffer()) {
        context.check(context.vk.vkBindBufferMemory(context.device, parts.buffer, memory, offset),
                      "vkBindBufferMemory");
        return read_address();
    }
    context.check(context.vk.vkBindImageMemory(context.device, parts.image, memory, offset), "vkBindImageMemory");
    make_views();
}

void VulkanMemory::make_views() {
    const MemoryDescription& d = description();
    const MemoryParts::PartViews views = made_views(owner().context(), parts, d, {0, d.mips, 0, face_count(d)});
    parts.sampled_view = views.sampled_view;
    parts.storage_view = views.storage_view;
}

void VulkanMemory::adopt(VkImage image, VkImageUsageFlags usage, VkImageCreateFlags flags) {
    parts.image = image;
    parts.usage = usage;
    parts.is_users = true;
    parts.is_mutable = (flags & VK_IMAGE_CREATE_MUTABLE_FORMAT_BIT) != 0;
    make_views();
}

namespace {

const char* usage_text(VkImageUsageFlagBits usage) {
    switch (usage) {
    case VK_IMAGE_USAGE_TRANSFER_SRC_BIT: return "VK_IMAGE_USAGE_TRANSFER_SRC_BIT";
    case VK_IMAGE_USAGE_TRANSFER_DST_BIT: return "VK_IMAGE_USAGE_TRANSFER_DST_BIT";
    case VK_IMAGE_USAGE_SAMPLED_BIT: return "VK_IMAGE_USAGE_SAMPLED_BIT";
    case VK_IMAGE_USAGE_STORAGE_BIT: return "VK_IMAGE_USAGE_STORAGE_BIT";
    case VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT: return "VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT";
    case VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT: return "VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT";
    default: return "another usage";
    }
}

}  // namespace

void VulkanMemory::require(VkImageUsageFlagBits usage) const {
    const MemoryParts& all = whole() ? static_cast<const VulkanMemory&>(*whole()).parts : parts;
    if (!all.is_users || all.usage & usage) return;
    throw Error(ErrorCode::missing_feature, "an adopted image was made without a usage that is needed",
                memory_text(description()), std::string("missing: ") + usage_text(usage),
                "make the image with it, and name it in glift::vulkan::UserImage::usage");
}

const MemoryParts::PartViews& VulkanMemory::views_of(const MemoryDescription& description, const Texels& texels) {
    for (const MemoryParts::PartViews& known : parts.part_views)
        if (known.texels == texels && known.kind == description.kind) return known;
    parts.part_views.push_back(made_views(owner().context(), parts, description, texels));
    return parts.part_views.back();
}

VkImageView VulkanMemory::attachment_view(std::uint32_t mip, std::uint32_t face) {
    if (whole()) {
        VulkanMemory& image = static_cast<VulkanMemory&>(*whole());
        return image.attachment_view(texels().mip + mip, texels().layer + face);
    }
    for (const MemoryParts::AttachmentView& known : parts.attachment_views)
        if (known.mip == mip && known.face == face) return known.view;
    Context& context = owner().context();
    const MemoryDescription& d = description();
    require(d.format == Format::d32 ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT
                                    : VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
    const VkImageUsageFlags usage =
        parts.usage & (VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
    if (!usage)
        throw Error(ErrorCode::missing_feature, "the device cannot draw to images of this kind and format",
                    memory_text(d), context.properties.name, "use another texel format, and a 2-D image or a cube");
    const VkImageSubresourceRange range = {vulkan_aspect(d.format), mip, 1, face, 1};
    const VkImageView view = make_view(context, parts.image, d, VK_IMAGE_VIEW_TYPE_2D, range, usage);
    parts.attachment_views.push_back({mip, face, view});
    return view;
}

VulkanMemory::Views VulkanMemory::views_as(MemoryKind kind) {
    if (kind == description().kind) return {parts.sampled_view, parts.storage_view};
    VulkanMemory& image = whole() ? static_cast<VulkanMemory&>(*whole()) : *this;
    MemoryDescription other = description();
    const Texels all = whole() ? texels() : Texels{0, other.mips, 0, face_count(other)};
    other.kind = kind;
    const MemoryParts::PartViews& views = image.views_of(other, all);
    return {views.sampled_view, views.storage_view};
}

VkImageView VulkanMemory::bits_view(MemoryKind kind) {
    return whole() ? static_cast<VulkanMemory&>(*whole()).bits_view(kind, texels())
                   : bits_view(kind, {0, 1, 0, face_count(description())});
}

VkImageView VulkanMemory::bits_view(MemoryKind kind, const Texels& texels) {
    for (const MemoryParts::BitsView& known : parts.bits_views)
        if (known.texels == texels && known.kind == kind) return known.view;
    const MemoryDescription& d = description();
    if (parts.is_users && !parts.is_mutable)
        throw Error(ErrorCode::missing_feature, "floats of an adopted image are combined as integers", memory_text(d),
                    "it has no views of another format",
                    "make the image with VK_IMAGE_CREATE_MUTABLE_FORMAT_BIT, and name it in "
                    "glift::vulkan::UserImage::flags");
    const VkImageSubresourceRange range = {vulkan_aspect(d.format), texels.mip, 1, texels.layer, texels.layers};
    const VkImageView view =
        make_view(owner().context(), parts.image, d, view_type(kind), range, VK_IMAGE_USAGE_STORAGE_BIT, bits_format);
    parts.bits_views.push_back({texels, kind, view});
    return view;
}

void VulkanMemory::read_address() {
    Context& context = owner().context();
    const VkBufferDeviceAddressInfo info = {.sType = VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO,
                                            .buffer = parts.buffer};
    address = context.vk.vkGetBufferDeviceAddress(context.device, &info);
}

bool VulkanMemory::is_in_pieces() const { return is_buffer() && range > owner().context().max_piece_bytes; }

void VulkanMemory::place(std::vector<Allocation> pieces) {
    parts.pieces = std::move(pieces);
    bind_pieces(owner().context(), parts.buffer, parts.pieces);
    read_address();
}

void VulkanMemory::place(const Allocation& own) {
    parts.allocation = own;
    bind(own.memory, own.offset);
}

void VulkanMemory::place(std::shared_ptr<VulkanMemory> block, VkDeviceSize offset) {
    block_ = std::move(block);
    bind(block_->parts.allocation.memory, block_->parts.allocation.offset + offset);
}

}  // namespace glift::detail
