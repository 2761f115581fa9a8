// Recordings, and commands for the user's own command buffer.
#include "../report.h"
#include "../text.h"
#include "vulkan_device.h"
#include "vulkan_stream.h"

#include <glift/error.h>

namespace glift::detail {

namespace {

class VulkanRecording final : public RecordingObject {
public:
    VulkanRecording(std::shared_ptr<VulkanDevice> device, std::unique_ptr<CommandBatch> batch, std::vector<Memory> held,
                    std::uint64_t workspace_bytes)
        : device_(std::move(device)), batch_(std::move(batch)), held_(std::move(held)),
          workspace_bytes_(workspace_bytes) {}

    ~VulkanRecording() override {
        const std::lock_guard lock(device_->mutex());
        device_->give_back(std::move(batch_));
    }

    DeviceObject& device() const override { return *device_; }
    void submit() override {
        require_current(held_);
        const std::lock_guard lock(device_->mutex());
        device_->stream_of_device().submit();
        if (batch_->times) await_times();
        if (device_->profiler().is_on() && !batch_->times) {
            device_->stream_of_device().timed({.name = "recording", .has_uncounted_bytes = true}, [&] { run(); });
        } else {
            run();
        }
        device_->counters().passes += batch_->passes;
        device_->collect();
    }

    std::uint64_t workspace_bytes() const override { return workspace_bytes_; }

private:
    void run() {
        batch_->value = device_->submit(batch_->commands);
        if (batch_->prints) device_->note_printing(batch_->value);
        if (device_->profiler().is_on() && batch_->times) device_->pass_times().add(batch_->times, batch_->value);
    }

    /// The replay would write over the timestamps of the last one.
    void await_times() {
        const std::uint64_t value = device_->pass_times().unread(*batch_->times);
        if (value == 0) return;
        device_->timeline().wait(value);
        device_->collect();
    }

    std::shared_ptr<VulkanDevice> device_;
    std::unique_ptr<CommandBatch> batch_;
    std::vector<Memory> held_;
    std::uint64_t workspace_bytes_;
};

}  // namespace

HoldingStream::HoldingStream(std::shared_ptr<VulkanDevice> device) : VulkanStream(*device), keep_(std::move(device)) {
    const std::lock_guard lock(device_.mutex());
    batch_ = device_.take_batch();
}

// The device is done with the batch: a recording took it along in finish(), and the user's program keeps a stream until
// its command buffer has run.
HoldingStream::~HoldingStream() {
    if (!batch_) return;
    const std::lock_guard lock(device_.mutex());
    device_.give_back(std::move(batch_));
}

std::shared_ptr<DeviceObject> HoldingStream::device() { return keep_; }

void HoldingStream::open() {
    device_.context().require_not_lost();
    if (is_closed()) throw_closed("Commands");
}

void HoldingStream::hold(const Memory& memory) {
    const std::uint32_t slot = vulkan_memory(memory).id.slot;
    if (slot >= held_slots_.size()) held_slots_.resize(slot + 64);
    if (held_slots_[slot]) return;
    held_slots_[slot] = true;
    held_.push_back(kept(memory));
}

namespace {

[[noreturn]] void throw_in_pieces(const MemoryDescription& description) {
    throw Error(ErrorCode::too_large, "a temporary of a recording is larger than one allocation",
                memory_text(description), size_text(description.bytes) + " asked for",
                "make the structure before the recording, and pass it");
}

}  // namespace

Memory HoldingStream::allocate(const MemoryDescription& description) {
    const std::lock_guard lock(device_.mutex());
    open();
    if (description.kind != MemoryKind::buffer) {
        const std::shared_ptr<VulkanMemory> image = device_.new_memory(description);
        workspace_->add(image->parts.allocation.bytes);
        return Memory(image);
    }
    const std::shared_ptr<VulkanMemory> buffer = device_.new_object(description);
    if (buffer->is_in_pieces()) throw_in_pieces(description);
    const Workspace::Place place = workspace_->take(device_.storage_needs(description));
    if (place.is_new_block) {
        blocks_.push_back(device_.new_memory({.name = description.name, .bytes = place.bytes, .zeroed = false}));
    } else if (place.is_just_free) {
        // One note is enough for all storage that is free by now: the next barrier waits for everything before it.
        encoder_.note_storage_reuse();
    }
    buffer->place(blocks_[place.block], place.offset);
    return temporary(buffer, workspace_, place);
}

std::shared_ptr<DownloadObject> HoldingStream::download(const Memory&, std::span<const CopyRegion>, std::uint64_t) {
    throw_not_in_recording("Commands::download");
}

std::shared_ptr<DownloadObject> HoldingStream::download_image(const Memory&, std::span<const ImageRegion>,
                                                              std::uint64_t) {
    throw_not_in_recording("Commands::download_image");
}

std::shared_ptr<TimestampObject> HoldingStream::timestamp() { throw_not_in_recording("Commands::timestamp"); }
void HoldingStream::flush() { throw_not_in_recording("Commands::flush"); }
void HoldingStream::wait() { throw_not_in_recording("Commands::wait"); }

RecordingStream::RecordingStream(std::shared_ptr<VulkanDevice> device) : HoldingStream(std::move(device)) {
    const std::lock_guard lock(device_.mutex());
    // A replay may start before the previous one is done; barriers at both ends order them.
    batch_->begin(VK_COMMAND_BUFFER_USAGE_SIMULTANEOUS_USE_BIT);
    encoder_.target(batch_->commands, *batch_);
    encoder_.full_barrier();
}

void RecordingStream::count_pass() { ++batch_->passes; }

Query RecordingStream::take_query() {
    if (!batch_->times) batch_->times = std::make_shared<RecordedTimes>(device_.context());
    return batch_->times->take(batch_->commands);
}

void RecordingStream::note_times(TimedWork times) { batch_->times->add(std::move(times)); }

std::shared_ptr<RecordingObject> RecordingStream::finish() {
    const std::lock_guard lock(device_.mutex());
    open();
    close();
    encoder_.full_barrier();
    encoder_.close_labels();
    Context& context = device_.context();
    context.check(context.vk.vkEndCommandBuffer(batch_->commands), "vkEndCommandBuffer");
    return std::make_shared<VulkanRecording>(keep_, std::move(batch_), std::move(held_), workspace_->bytes());
}

ExternalStream::ExternalStream(std::shared_ptr<VulkanDevice> device, VkCommandBuffer commands)
    : HoldingStream(std::move(device)) {
    const std::lock_guard lock(device_.mutex());
    device_.stream_of_device().submit();
    encoder_.target(commands, *batch_);
    encoder_.full_barrier();
}

// The user's program may have bound pipelines of its own since Glift's last command.
void ExternalStream::open() {
    HoldingStream::open();
    encoder_.forget_pipeline();
}

void ExternalStream::finish() {
    const std::lock_guard lock(device_.mutex());
    open();
    close();
    encoder_.full_barrier();
    // Images that were made meanwhile get their layout in the device's own stream: submitted here, it runs before the
    // user's command buffer.
    device_.stream_of_device().submit();
}

}  // namespace glift::detail
