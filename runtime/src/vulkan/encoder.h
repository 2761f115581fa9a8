// Turns passes and copies into Vulkan commands, with the barriers that they need.
#pragma once

#include "../objects.h"
#include "command_batch.h"
#include "groups.h"
#include "hazards.h"
#include "labels.h"
#include "vulkan/memory/vulkan_memory.h"

namespace glift::detail {

class Encoder {
public:
    explicit Encoder(VulkanDevice& device);

    /// Records into this command buffer from now on. Nothing is bound there yet.
    void target(VkCommandBuffer commands, CommandBatch& batch) {
        commands_ = commands;
        batch_ = &batch;
        bound_ = VK_NULL_HANDLE;
        prepared_ = {};
    }
    CommandBatch& batch() { return *batch_; }
    VkCommandBuffer commands() const { return commands_; }
    Labels& labels() { return labels_; }
    void close_labels() { labels_.close(commands_); }
    void forget_pipeline() { bound_ = VK_NULL_HANDLE; }

    bool can_be_direct(const Kernel& kernel, std::span<const Memory> memories, const std::array<std::uint32_t, 4>& size,
                       Sharing sharing) const;
    void dispatch(const Kernel& kernel, const Call& call);

    void fill(const VulkanMemory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value);
    void fill_where(const VulkanMemory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value,
                    std::span<const Condition> conditions);
    void clear(const VulkanMemory& memory);
    void clear_new(const VulkanMemory& memory);  ///< a new memory's first commands: an image gets its layout; zeros are
                                                 ///< written if the description asks for them
    void copy(const VulkanMemory& from, const VulkanMemory& to, std::span<const CopyRegion> regions);
    void copy_to_image(const VulkanMemory& buffer, const VulkanMemory& image, std::span<const ImageRegion> regions);
    void copy_from_image(const VulkanMemory& image, const VulkanMemory& buffer, std::span<const ImageRegion> regions);
    void copy_images(const VulkanMemory& from, const VulkanMemory& to, std::span<const ImageCopyRegion> regions);
    void upload(const VulkanMemory& to, std::span<const CopyRegion> regions, const std::byte* bytes);
    void upload_filled(const VulkanMemory& to, std::uint64_t bytes, const Stream::Fill& fill);
    void upload_image(const VulkanMemory& image, std::span<const ImageRegion> regions, const std::byte* bytes);
    Slice download(const VulkanMemory& from, std::span<const CopyRegion> regions, std::uint64_t bytes);
    Slice download_image(const VulkanMemory& image, std::span<const ImageRegion> regions, std::uint64_t bytes);
    void timestamp(VkQueryPool pool, std::uint32_t query);

    /// Notes that a memory got storage that other memories of this stream used: the next access needs a barrier.
    void note_storage_reuse() { hazards_.note_storage_reuse(); }

    /// A barrier that orders everything before it on the queue before everything after it, on the queue and on the
    /// host.
    void full_barrier();

private:
    void barrier();
    void barrier(const VkMemoryBarrier2& what);
    void barrier_before_indirect();
    void fill_in_parts(const VulkanMemory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value);
    void clear_image(const VulkanMemory& memory);
    void touch(const VulkanMemory& memory, Access access);
    void touch(const VulkanMemory& from, const VulkanMemory& to);
    void check_form(const Kernel& kernel, const Call& call) const;
    bool fit_descriptors(std::span<const Memory> memories) const;
    void order(const Kernel& kernel, const Call& call);
    Slice write_parameters(const Pipeline& pipeline, const Call& call);
    void bind(const Pipeline& pipeline, const Call& call, const Slice& block);
    void push_descriptors(const Pipeline& pipeline, const Call& call, const Slice& block);
    void begin_messages(const Pipeline& pipeline);
    void dispatch_split(const Pipeline& pipeline, const Call& call, const Groups& groups);
    void dispatch_part(const Pipeline& pipeline, const Call& call, const Groups& groups);

    // encoder_indirect.cpp
    struct PrepareArguments;
    Slice prepare(PrepareArguments arguments, std::span<const Patch> patches, std::span<const Condition> conditions);
    Slice prepare(const Pipeline& pipeline, const Call& call, const Slice& block,
                  const std::array<std::uint32_t, 4>& size);
    bool patches_size(const Pipeline& pipeline, const Call& call) const;
    bool is_prepared_with(std::span<const Patch> patches, std::span<const Condition> conditions) const;
    void open_preparation(std::span<const Patch> patches, std::span<const Condition> conditions);

    // encoder_draws.cpp
    void draw(const Pipeline& pipeline, const Call& call);
    void begin_rendering(const Drawing& drawing, const DrawTargets& targets);
    void set_viewport(const DrawTargets& targets);
    void order_targets(const Kernel& kernel, const Call& call);

    VulkanDevice& device_;
    Context& context_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    CommandBatch* batch_ = nullptr;
    VkPipeline bound_ = VK_NULL_HANDLE;
    Labels labels_;
    Hazards hazards_;
    /// The list of passes that the last preparing pass prepares (prepare_indirect.comp). Passes are added to the list
    /// as long as it has room and, since prepared_at_, no command has written the values that the added pass needs.
    Slice prepared_;
    std::uint32_t prepared_count_ = 0;
    std::uint64_t prepared_at_ = 0;  ///< Hazards::ordered_writes() when the preparing pass was recorded
    bool reported_ = false;          ///< a draw since the last barrier may have written its status record
    bool draws_ = false;             ///< barriers order graphics stages, too: from the first draw on
};

}  // namespace glift::detail
