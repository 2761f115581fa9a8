#include "immediate_stream.h"

#include "vulkan_device.h"

namespace glift::detail {

namespace {

constexpr std::uint64_t most_operations = 512;  // a batch is then submitted, so that the device need not idle
constexpr std::size_t most_in_flight = 32;      // batches; bounds how far the host may run ahead of the device
constexpr std::uint64_t most_staged = std::uint64_t(64) << 20;
constexpr std::size_t most_staged_in_flight = 4;  // batches, when uploads have staged most_staged bytes

class VulkanDownload final : public DownloadObject {
public:
    VulkanDownload(std::shared_ptr<VulkanDevice> device, std::shared_ptr<Chunk> chunk, std::span<const std::byte> bytes,
                   std::uint64_t value)
        : device_(std::move(device)), chunk_(std::move(chunk)), bytes_(bytes), value_(value) {}

    bool ready() override { return device_->timeline().completed() >= value_; }
    std::span<const std::byte> get() override {
        device_->finish(value_);
        return bytes_;
    }

private:
    std::shared_ptr<VulkanDevice> device_;  // outlives the chunk
    std::shared_ptr<Chunk> chunk_;
    std::span<const std::byte> bytes_;
    std::uint64_t value_;
};

class VulkanTimestamp final : public TimestampObject {
public:
    VulkanTimestamp(std::shared_ptr<VulkanDevice> device, Query query, std::uint64_t value)
        : device_(std::move(device)), query_(query), value_(value) {}
    ~VulkanTimestamp() override { device_->retire(query_); }

    double seconds() override {
        if (seconds_ < 0) {
            device_->finish(value_);
            seconds_ = device_->queries().seconds(query_);
        }
        return seconds_;
    }

private:
    std::shared_ptr<VulkanDevice> device_;
    Query query_;
    std::uint64_t value_;
    double seconds_ = -1;
};

}  // namespace

ImmediateStream::~ImmediateStream() = default;

std::shared_ptr<DeviceObject> ImmediateStream::device() { return device_.shared_from_this(); }

std::uint64_t ImmediateStream::open_value() const { return device_.timeline().submitted() + 1; }

void ImmediateStream::open() {
    if (batch_ && ends_in_download_) submit();
    if (!batch_) open_batch();
}

Query ImmediateStream::take_query() { return device_.queries().take(); }

void ImmediateStream::note_times(TimedWork times) { device_.pass_times().add(std::move(times), open_value()); }

void ImmediateStream::open_batch() {
    device_.context().require_not_lost();
    device_.collect();
    while (in_flight_.size() >= most_in_flight) {
        device_.timeline().wait(in_flight_.front()->value);
        device_.collect();
    }
    std::unique_ptr<CommandBatch> batch = device_.take_batch();
    batch->begin(VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT);
    batch_ = std::move(batch);
    encoder_.target(batch_->commands, *batch_);
    // The barriers within batches order Glift's own work; this one orders it against the user's work on the queue.
    if (device_.context().shares_queue) encoder_.full_barrier();
    device_.set_retire_value(open_value());
}

void ImmediateStream::hold_back(std::uint64_t gate) {
    submit();
    open_batch();
    batch_->gate = gate;
    encoder_.full_barrier();  // what the host wrote before it opened the gate
}

void ImmediateStream::recorded() {
    if (batch_->operations >= most_operations) submit();
}

void ImmediateStream::staged(std::uint64_t bytes) {
    staged_bytes_ += bytes;
    if (staged_bytes_ < most_staged) return;
    if (batch_) submit();
    staged_bytes_ = 0;
    if (in_flight_.size() > most_staged_in_flight) {
        device_.timeline().wait(in_flight_[in_flight_.size() - most_staged_in_flight - 1]->value);
        device_.collect();
    }
}

void ImmediateStream::submit() {
    if (!batch_) return;
    std::unique_ptr<CommandBatch> batch = std::move(batch_);
    ends_in_download_ = false;
    staged_bytes_ = 0;
    encoder_.full_barrier();
    encoder_.close_labels();
    Context& context = device_.context();
    context.check(context.vk.vkEndCommandBuffer(batch->commands), "vkEndCommandBuffer");
    try {
        batch->value = device_.submit(batch->commands, batch->gate);
    } catch (...) {
        device_.give_back(std::move(batch));
        throw;
    }
    if (batch->prints) device_.note_printing(batch->value);
    in_flight_.push_back(std::move(batch));
}

void ImmediateStream::collect(std::uint64_t completed) {
    while (!in_flight_.empty() && in_flight_.front()->value <= completed) {
        device_.give_back(std::move(in_flight_.front()));
        in_flight_.pop_front();
    }
}

void ImmediateStream::clear_new(const VulkanMemory& memory) {
    if (memory.is_buffer() && !memory.description().zeroed) return;
    open();
    marked([&] { return Work{.name = "clear", .bytes = memory.description().bytes}; },
           [&] { encoder_.clear_new(memory); });
    recorded();
}

std::shared_ptr<DownloadObject> ImmediateStream::ticket(const Slice& slice, std::uint64_t bytes) {
    auto result = std::make_shared<VulkanDownload>(std::static_pointer_cast<VulkanDevice>(device_.shared_from_this()),
                                                   batch_->readback.current(),
                                                   std::span<const std::byte>(slice.data, bytes), open_value());
    ends_in_download_ = true;
    ++batch_->operations;
    return result;
}

std::shared_ptr<DownloadObject> ImmediateStream::download(const Memory& from, std::span<const CopyRegion> regions,
                                                          std::uint64_t bytes) {
    const std::lock_guard lock(device_.mutex());
    if (!batch_) open_batch();
    Slice slice;
    marked([&] { return work_of("download", regions); },
           [&] { slice = encoder_.download(vulkan_memory(from), regions, bytes); });
    return ticket(slice, bytes);
}

std::shared_ptr<DownloadObject>
ImmediateStream::download_image(const Memory& image, std::span<const ImageRegion> regions, std::uint64_t bytes) {
    const std::lock_guard lock(device_.mutex());
    if (!batch_) open_batch();
    Slice slice;
    marked([&] { return work_of("download", image, regions); },
           [&] { slice = encoder_.download_image(vulkan_memory(image), regions, bytes); });
    return ticket(slice, bytes);
}

std::shared_ptr<TimestampObject> ImmediateStream::timestamp() {
    const std::lock_guard lock(device_.mutex());
    open();
    const Query query = device_.queries().take();
    encoder_.timestamp(query.pool, query.index);
    auto result = std::make_shared<VulkanTimestamp>(std::static_pointer_cast<VulkanDevice>(device_.shared_from_this()),
                                                    query, open_value());
    recorded();
    return result;
}

void ImmediateStream::flush() {
    const std::lock_guard lock(device_.mutex());
    submit();
}

void ImmediateStream::wait() { device_.finish(UINT64_MAX); }

}  // namespace glift::detail
