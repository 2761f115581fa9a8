#include "vulkan_device.h"

#include "../profile/process_profile.h"
#include "../report.h"
#include "../text.h"
#include "begin_messages.h"
#include "fill_words.h"
#include "points.h"
#include "prepare_indirect.h"
#include "vulkan/memory/sparse_binding.h"

#include <glift/error.h>

#include <algorithm>
#include <cstring>
#include <tuple>

namespace glift::detail {

namespace {

constexpr std::size_t most_idle_batches = 40;  // as many as may be in flight, and some recordings

}  // namespace

std::shared_ptr<DeviceObject> open_vulkan_device(std::string_view which, const Context::Wanted& extensions) {
    return std::make_shared<VulkanDevice>(Context::open(which, extensions));
}

VulkanDevice::VulkanDevice(std::unique_ptr<Context> context)
    : context_(std::move(context)), timeline_(std::make_unique<Timeline>(*context_, context_->queue)),
      exit_wait_(*timeline_), allocator_(std::make_unique<Allocator>(*context_)),
      chunks_(std::make_unique<ChunkPool>(*context_, *allocator_)), pipelines_(std::make_unique<Pipelines>(*context_)),
      queries_(std::make_unique<Queries>(*context_)), pass_times_(std::make_unique<PassTimes>(*queries_, profiler())),
      prepare_(*context_, "glift prepare indirect", ::prepare_indirect, sizeof(VkDeviceAddress)),
      fill_(*context_, "glift fill", ::fill_words, sizeof(FillArguments)),
      begin_messages_(*context_, "glift messages", ::begin_messages, sizeof(MessagesArguments)),
      stream_(std::make_unique<ImmediateStream>(*this)) {
    status_ = chunks_->take(MemoryUse::readback, status_slots * status_stride);
    std::memset(status_->allocation.mapped, 0, status_slots * status_stride);
}

VulkanDevice::~VulkanDevice() {
    // No memory, recording or download is left, so commands not yet submitted have no effect that anyone could see,
    // except on images of the user's (adopt_image): for these the program has to call flush or wait before.
    // What kernels print is seen: commands that print are submitted.
    try {
        if (message_chunk_ && !context_->lost) stream_->submit();
        if (!context_->lost) timeline_->wait(timeline_->submitted());
        messages().deliver(take_messages());
    } catch (const Error&) {
        // If the device was lost meanwhile there is nothing to wait for. If host memory ran out, this call may succeed.
        if (!context_->lost) std::ignore = context_->vk.vkQueueWaitIdle(context_->queue);
    }
    keep_times();
    stream_.reset();
    completed_ = UINT64_MAX;
    destroy_retired(completed_);
    idle_batches_.clear();
    status_.reset();
    pass_times_.reset();
    link_.reset();
    message_chunk_.reset();
    queries_.reset();
    pipelines_.reset();
    chunks_->clear();
}

void VulkanDevice::start_profile() {
    if (!context_->timestamp_bits)
        throw Error(ErrorCode::missing_feature, "the device's queue has no timestamps, which a profile needs",
                    context_->properties.name, {}, "profile on the host device (GLIFT_DEVICE=host) or on another one");
    profiler().turn_on();
}

void VulkanDevice::finish_profile() {
    timeline_->wait(timeline_->submitted());
    const std::lock_guard lock(mutex_);
    collect();
}

void VulkanDevice::keep_times() {
    try {
        if (!context_->lost) pass_times_->read(timeline_->completed());
    } catch (const Error&) {
        // A lost device has no times.
    }
    keep_profile(*this);
}

MemoryId VulkanDevice::new_id() {
    MemoryId id = {slots_, ++serial_};
    if (free_slots_.empty()) {
        ++slots_;
    } else {
        id.slot = free_slots_.back();
        free_slots_.pop_back();
    }
    return id;
}

std::shared_ptr<MemoryObject> VulkanDevice::allocate(const MemoryDescription& description) {
    const std::lock_guard lock(mutex_);
    return new_memory(description);
}

LinkObject* VulkanDevice::link() {
    const std::lock_guard lock(mutex_);
    if (!link_ && context_->can_link()) link_ = std::make_unique<VulkanLink>(*this);
    return link_.get();
}

std::shared_ptr<VulkanMemory> VulkanDevice::new_linked_memory(const MemoryDescription& description) {
    auto memory = unmade_object(description);
    memory->make(UsedBy::all_queues);
    if (memory->is_in_pieces()) throw_too_large(description);
    Allocation own;
    allocate_parts(VulkanMemory::needs_of(*this, description), true, description, own);
    memory->place(own);
    return memory;
}

VisibleMemory VulkanDevice::allocate_visible(const MemoryDescription& description) {
    const std::lock_guard lock(mutex_);
    const auto memory = new_object(description);
    const VkMemoryRequirements needs = VulkanMemory::needs_of(*this, description);
    if (memory->is_in_pieces()) throw_too_large(description);
    Allocation own;
    if (!allocator_->allocate(needs, MemoryUse::readback, true, own)) throw_out_of_memory(needs.size, description);
    memory->place(own);
    return {Memory(memory), {own.mapped, description.bytes}};
}

std::shared_ptr<PointObject> VulkanDevice::point() {
    const std::lock_guard lock(mutex_);
    stream_->submit();
    return std::make_shared<VulkanPoint>(shared_from_this(), *timeline_, timeline_->submitted());
}

std::shared_ptr<GateObject> VulkanDevice::gate() {
    const std::lock_guard lock(mutex_);
    const std::uint64_t number = timeline_->new_gate();
    stream_->hold_back(number);
    return std::make_shared<VulkanGate>(shared_from_this(), *timeline_, number);
}

std::shared_ptr<VulkanMemory> VulkanDevice::new_memory(const MemoryDescription& description) {
    const auto memory = new_object(description);
    const VkMemoryRequirements needs = VulkanMemory::needs_of(*this, description);
    if (memory->is_in_pieces()) {
        memory->place(allocate_pieces(needs, description));
    } else {
        Allocation own;
        allocate_parts(needs, memory->is_buffer(), description, own);
        memory->place(own);
    }
    stream_->clear_new(*memory);
    return memory;
}

std::shared_ptr<VulkanMemory> VulkanDevice::unmade_object(const MemoryDescription& description) {
    context_->require_not_lost();
    collect();
    auto memory = std::make_shared<VulkanMemory>(shared_from_this(), description);
    memory->id = new_id();
    ++memories_;
    return memory;
}

std::shared_ptr<VulkanMemory> VulkanDevice::new_object(const MemoryDescription& description) {
    auto memory = unmade_object(description);
    memory->make();
    return memory;
}

std::shared_ptr<VulkanMemory> VulkanDevice::adopted_image(const MemoryDescription& description, VkImage image,
                                                          VkImageUsageFlags usage, VkImageCreateFlags flags) {
    auto memory = unmade_object(description);
    memory->adopt(image, usage, flags);
    return memory;
}

StorageNeeds VulkanDevice::storage_needs(const MemoryDescription& description) {
    const VkMemoryRequirements needs = VulkanMemory::needs_of(*this, description);
    return {needs.size, needs.alignment, description.kind == MemoryKind::buffer};
}

void VulkanDevice::throw_too_large(const MemoryDescription& description) const {
    const bool is_buffer = description.kind == MemoryKind::buffer;
    const std::uint64_t allowed = is_buffer ? context_->properties.max_allocation_bytes : context_->max_piece_bytes;
    throw Error(
        ErrorCode::too_large, "a memory is larger than the device can allocate at once", memory_text(description),
        size_text(description.bytes) + " asked for; " + context_->properties.name + " allows " + size_text(allowed),
        "split the structure into several, or use a device with a larger limit (GLIFT_DEVICE=host has none)");
}

void VulkanDevice::allocate_parts(const VkMemoryRequirements& needs, bool linear, const MemoryDescription& description,
                                  Allocation& result) {
    if (allocator_->allocate(needs, MemoryUse::device, linear, result)) return;
    // Freed memories are kept until the device is done with them: wait for that, then try again.
    stream_->submit();
    timeline_->wait(timeline_->submitted());
    collect();
    chunks_->clear();
    if (allocator_->allocate(needs, MemoryUse::device, linear, result)) return;
    throw_out_of_memory(needs.size, description);
}

std::vector<Allocation> VulkanDevice::allocate_pieces(const VkMemoryRequirements& needs,
                                                      const MemoryDescription& description) {
    if (needs.size > context_->properties.memory_bytes) throw_out_of_memory(needs.size, description);
    const VkDeviceSize most = std::min<VkDeviceSize>(largest_piece, context_->max_piece_bytes);
    std::vector<Allocation> pieces;
    try {
        for (VkDeviceSize rest = needs.size; rest != 0;) {
            VkMemoryRequirements piece = needs;
            piece.size = std::min(rest, most / needs.alignment * needs.alignment);
            Allocation made;
            allocate_parts(piece, true, description, made);
            pieces.push_back(made);
            rest -= piece.size;
        }
    } catch (const Error& error) {
        for (const Allocation& piece : pieces) allocator_->free(piece);
        if (error.code() != ErrorCode::out_of_memory) throw;
        throw_out_of_memory(needs.size, description);
    }
    return pieces;
}

void VulkanDevice::throw_out_of_memory(std::uint64_t bytes, const MemoryDescription& description) const {
    // What Glift holds and the reported heap are both given, since some drivers allocate more than they report.
    std::string why = size_text(bytes) + " asked for; Glift holds " + size_text(allocator_->reserved()) + " (" +
                      size_text(allocator_->used()) + " in use), on the device and for staging; " +
                      context_->properties.name + " reports a heap of " + size_text(context_->properties.memory_bytes);
    if (allocator_->limit() != UINT64_MAX) why += "; GLIFT_MEMORY_LIMIT is " + size_text(allocator_->limit());
    throw Error(ErrorCode::out_of_memory, "the device has no memory left for a structure", memory_text(description),
                why,
                "free structures that are no longer used, make them smaller, or run on the host device "
                "(GLIFT_DEVICE=host)");
}

std::shared_ptr<Stream> VulkanDevice::begin_recording() {
    return std::make_shared<RecordingStream>(std::static_pointer_cast<VulkanDevice>(shared_from_this()));
}

std::shared_ptr<RecordingObject> VulkanDevice::end_recording(Stream& stream) {
    return static_cast<RecordingStream&>(stream).finish();
}

Statistics VulkanDevice::statistics() {
    const std::lock_guard lock(mutex_);
    Statistics result;
    result.submissions = counters_.submissions;
    result.passes = counters_.passes;
    result.barriers = counters_.barriers;
    result.pipelines = pipelines_->created();
    result.waits = waits_;
    result.memories = memories_;
    result.bytes_used = allocator_->used();
    result.bytes_reserved = allocator_->reserved();
    return result;
}

std::uint64_t VulkanDevice::submit(VkCommandBuffer commands, std::uint64_t gate) {
    context_->require_not_lost();
    if (!is_exit_prepared_ && pipelines_->created()) prepare_exit();
    const std::uint64_t value = timeline_->submit(commands, gate != 0 ? timeline_->opening_of(gate) : Moment());
    retire_value_ = value;
    ++counters_.submissions;
    return value;
}

/// Called when the driver has made a pipeline.
void VulkanDevice::prepare_exit() {
    is_exit_prepared_ = true;
    if (context_->properties.kind == DeviceKind::cpu) start_compiler();
    exit_wait_.renew();
}

/// Runs a shader that does nothing, once in a process. Drivers of CPUs compile a shader when it first runs: only then
/// is registered at exit what their compilers use.
void VulkanDevice::start_compiler() {
    static std::atomic<bool> is_started{false};
    if (is_started.exchange(true)) return;
    std::unique_ptr<CommandBatch> batch = take_batch();
    batch->begin(VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT);
    const FillArguments nothing = {};
    fill_.bind(batch->commands, &nothing);
    context_->vk.vkCmdDispatch(batch->commands, 1, 1, 1);
    context_->check(context_->vk.vkEndCommandBuffer(batch->commands), "vkEndCommandBuffer");
    const VkCommandBufferSubmitInfo buffer = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
                                              .commandBuffer = batch->commands};
    const VkSubmitInfo2 info = {
        .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2, .commandBufferInfoCount = 1, .pCommandBufferInfos = &buffer};
    context_->check(context_->vk.vkQueueSubmit2(context_->queue, 1, &info, VK_NULL_HANDLE), "vkQueueSubmit2");
    context_->check(context_->vk.vkQueueWaitIdle(context_->queue), "vkQueueWaitIdle");
    give_back(std::move(batch));
}

void VulkanDevice::share_queue() {
    if (context_->shares_queue) return;
    // The open batch does not begin with a barrier against the program's work.
    stream_->submit();
    context_->shares_queue = true;
}

void VulkanDevice::finish(std::uint64_t value) {
    {
        const std::lock_guard lock(mutex_);
        if (value > timeline_->submitted()) stream_->submit();
        value = std::min(value, timeline_->submitted());
    }
    ++waits_;
    timeline_->wait(value);
    std::vector<Message> printed;
    {
        const std::lock_guard lock(mutex_);
        printed = take_messages();
    }
    messages().deliver(printed);
    {
        const std::lock_guard lock(mutex_);
        check_reports();
    }
    messages().throw_failed();
}

const Chunk& VulkanDevice::message_chunk() {
    if (message_chunk_) return *message_chunk_;
    const std::uint64_t bytes = std::min(message_bytes(), context_->properties.max_storage_buffer_range);
    std::shared_ptr<Chunk> chunk = chunks_->take(MemoryUse::readback, bytes);
    std::memset(chunk->allocation.mapped, 0, chunk->bytes);
    const MessageHeader header = {.capacity = static_cast<std::uint32_t>((bytes - sizeof header) / 4)};
    std::memcpy(chunk->allocation.mapped, &header, sizeof header);
    message_chunk_ = std::move(chunk);
    return *message_chunk_;
}

std::uint32_t VulkanDevice::printing_kernel(const Pipeline& pipeline) {
    return printing_.number_of(pipeline.digest, *pipeline.kernel);
}

/// What was printed by all submissions so far.
std::vector<Message> VulkanDevice::take_messages() {
    if (!message_chunk_ || context_->lost) return {};
    timeline_->wait(printing_value_);
    return printing_.take(*reinterpret_cast<MessageHeader*>(message_chunk_->allocation.mapped));
}

void VulkanDevice::check_reports() {
    const auto& kernels = pipelines_->reporting();
    for (std::size_t k = 0; k < kernels.size(); ++k) {
        std::byte* slot = status_->allocation.mapped + k * status_stride;
        StatusRecord record;
        std::memcpy(&record, slot, sizeof record);
        if (record.code == StatusRecord::fine) continue;
        std::memset(slot, 0, sizeof record);
        throw_report(kernels[k], record);
    }
}

void VulkanDevice::retire(const MemoryParts& parts, MemoryId id) {
    const std::lock_guard lock(retire_mutex_);
    retired_.push_back({retire_value_, parts, id, {}, nullptr});
}

void VulkanDevice::retire(Query query) {
    const std::lock_guard lock(retire_mutex_);
    retired_.push_back({retire_value_, {}, {}, query, nullptr});
}

std::unique_ptr<CommandBatch> VulkanDevice::take_batch() {
    if (idle_batches_.empty()) return std::make_unique<CommandBatch>(*context_, *chunks_);
    std::unique_ptr<CommandBatch> batch = std::move(idle_batches_.back());
    idle_batches_.pop_back();
    return batch;
}

void VulkanDevice::give_back(std::unique_ptr<CommandBatch> batch) {
    if (batch->value > completed_) {
        const std::lock_guard lock(retire_mutex_);
        retired_.push_back({batch->value, {}, {}, {}, std::move(batch)});
        return;
    }
    if (idle_batches_.size() == most_idle_batches) return;
    if (!batch->reset()) return;
    batch->value = 0;
    idle_batches_.push_back(std::move(batch));
}

void VulkanDevice::destroy(Retired& retired) {
    const DeviceTable& vk = context_->vk;
    if (retired.batch) give_back(std::move(retired.batch));
    if (retired.query.pool) queries_->give_back(retired.query);
    if (!retired.id.serial) return;
    const MemoryParts& parts = retired.parts;
    for (const MemoryParts::AttachmentView& attachment : parts.attachment_views)
        vk.vkDestroyImageView(context_->device, attachment.view, nullptr);
    for (const MemoryParts::PartViews& part : parts.part_views) {
        vk.vkDestroyImageView(context_->device, part.sampled_view, nullptr);
        vk.vkDestroyImageView(context_->device, part.storage_view, nullptr);
    }
    for (const MemoryParts::BitsView& bits : parts.bits_views)
        vk.vkDestroyImageView(context_->device, bits.view, nullptr);
    vk.vkDestroyImageView(context_->device, parts.sampled_view, nullptr);
    vk.vkDestroyImageView(context_->device, parts.storage_view, nullptr);
    if (!parts.is_users) vk.vkDestroyImage(context_->device, parts.image, nullptr);
    vk.vkDestroyBuffer(context_->device, parts.buffer, nullptr);
    allocator_->free(parts.allocation);
    for (const Allocation& piece : parts.pieces) allocator_->free(piece);
    free_slots_.push_back(retired.id.slot);
    --memories_;
}

void VulkanDevice::destroy_retired(std::uint64_t completed) {
    std::vector<Retired> done;
    {
        const std::lock_guard lock(retire_mutex_);
        const auto first = std::stable_partition(retired_.begin(), retired_.end(),
                                                 [&](const Retired& r) { return r.value > completed; });
        done.assign(std::make_move_iterator(first), std::make_move_iterator(retired_.end()));
        retired_.erase(first, retired_.end());
    }
    for (Retired& retired : done) destroy(retired);
}

void VulkanDevice::collect() {
    completed_ = timeline_->completed();
    stream_->collect(completed_);
    pass_times_->read(completed_);
    destroy_retired(completed_);
    chunks_->trim();
}

}  // namespace glift::detail
