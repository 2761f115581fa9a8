// A memory of a Vulkan device.
#pragma once

#include "allocator.h"
#include "objects.h"
#include "vulkan/hazards.h"

namespace glift::detail {

class VulkanDevice;

/// The Vulkan objects of a memory, destroyed when the device no longer uses them (except a user's image: is_users).
struct MemoryParts {
    VkBuffer buffer = VK_NULL_HANDLE;
    VkImage image = VK_NULL_HANDLE;
    VkImageUsageFlags usage = 0;                ///< of the image
    bool is_users = false;                      ///< an adopted image, which the user destroys
    bool is_mutable = false;                    ///< a user's image, which may have views of other formats
    VkImageView sampled_view = VK_NULL_HANDLE;  ///< all mips; null where `usage` has no sampling
    VkImageView storage_view = VK_NULL_HANDLE;  ///< mip 0; null where `usage` has no storage
    /// Views of levels and faces that have been drawn to.
    struct AttachmentView {
        std::uint32_t mip, face;
        VkImageView view;
    };
    std::vector<AttachmentView> attachment_views;
    /// Views of parts of the image (Memory::mip, Memory::layer), and of cubes as arrays of their faces (views_as).
    struct PartViews {
        Texels texels;
        MemoryKind kind;
        VkImageView sampled_view, storage_view;
    };
    std::vector<PartViews> part_views;
    /// Views of an image of floats, or of parts of it, as integers of the same bits: for kernels that combine its
    /// texels by atomic operations of integers (Binding::as_bits).
    struct BitsView {
        Texels texels;
        MemoryKind kind;
        VkImageView view;
    };
    std::vector<BitsView> bits_views;
    Allocation allocation;
    std::vector<Allocation> pieces;  ///< of a buffer larger than one allocation, in place of `allocation`
};

/// Whose commands use a buffer.
enum class UsedBy : std::uint8_t { own_queue, all_queues };

class VulkanMemory final : public MemoryObject {
public:
    VulkanMemory(std::shared_ptr<DeviceObject> device, const MemoryDescription& description);
    /// Makes a part of an image. The image owns the part's views, since command buffers that use them hold the image.
    VulkanMemory(const std::shared_ptr<VulkanMemory>& whole, const MemoryDescription& description,
                 const Texels& texels);
    ~VulkanMemory() override;

    std::shared_ptr<MemoryObject> part(const MemoryDescription& description, const Texels& texels) override;

    /// The requirements of a memory of this description; throws too_large, missing_feature.
    static VkMemoryRequirements needs_of(VulkanDevice& owner, const MemoryDescription& description);

    /// Creates the buffer or the image, without storage; throws as needs_of.
    void make(UsedBy users = UsedBy::own_queue);
    /// Instead of `make`: takes the user's image, which has storage.
    void adopt(VkImage image, VkImageUsageFlags usage, VkImageCreateFlags flags);
    /// Throws missing_feature where this is a user's image, or a part of one, that was made without this usage.
    void require(VkImageUsageFlagBits usage) const;
    /// Binds storage: its own, or a part of another memory's, which is kept alive.
    void place(const Allocation& own);
    void place(std::vector<Allocation> pieces);
    void place(std::shared_ptr<VulkanMemory> block, VkDeviceSize offset);

    /// The view of one level and face for draws; throws missing_feature. The device's lock is held.
    VkImageView attachment_view(std::uint32_t mip, std::uint32_t face);

    /// The views for a kernel's binding of this kind: a cube may be bound as an array of its faces, too. The device's
    /// lock is held.
    struct Views {
        VkImageView sampled, storage;
    };
    Views views_as(MemoryKind kind);
    /// The view of the first level of an image of floats as integers of the same bits; throws missing_feature. The
    /// device's lock is held.
    VkImageView bits_view(MemoryKind kind);

    VulkanDevice& owner() const;
    /// Whether this is a buffer that needs several allocations.
    bool is_in_pieces() const;
    bool is_buffer() const { return parts.buffer != VK_NULL_HANDLE; }

    MemoryParts parts;
    MemoryId id;
    VkDeviceSize range = 0;       ///< buffers: bytes that shaders may read, a multiple of 16, at least 16
    VkDeviceAddress address = 0;  ///< of a buffer

private:
    void bind(VkDeviceMemory memory, VkDeviceSize offset);
    void make_views();
    const MemoryParts::PartViews& views_of(const MemoryDescription& description, const Texels& texels);
    VkImageView bits_view(MemoryKind kind, const Texels& texels);
    void read_address();

    std::shared_ptr<VulkanMemory> block_;  ///< the memory whose storage this one shares; null: it has its own
};

inline VulkanMemory& vulkan_memory(const Memory& memory) { return static_cast<VulkanMemory&>(*memory.object()); }

VkFormat vulkan_format(Format format);
VkImageAspectFlags vulkan_aspect(Format format);

}  // namespace glift::detail
