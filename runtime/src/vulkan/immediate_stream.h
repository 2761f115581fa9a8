// A device's own stream: batches of commands, submitted as commands.h says.
#pragma once

#include "vulkan_stream.h"

#include <deque>

namespace glift::detail {

class ImmediateStream final : public VulkanStream {
public:
    using VulkanStream::VulkanStream;
    ~ImmediateStream() override;

    std::shared_ptr<DeviceObject> device() override;
    std::shared_ptr<DownloadObject> download(const Memory& from, std::span<const CopyRegion> regions,
                                             std::uint64_t bytes) override;
    std::shared_ptr<DownloadObject> download_image(const Memory& image, std::span<const ImageRegion> regions,
                                                   std::uint64_t bytes) override;
    std::shared_ptr<TimestampObject> timestamp() override;
    void flush() override;
    void wait() override;

    /// The caller holds the device's lock in these.
    void submit();
    void clear_new(const VulkanMemory& memory);
    /// Submits what was put into the stream, then what `submission` submits. The profiler sees the latter as one pass.
    template <class Submission> void timed(const Work& work, Submission&& submission);
    bool is_open() const { return batch_ != nullptr; }
    void hold_back(std::uint64_t gate);     ///< what is put into the stream from now on
    void collect(std::uint64_t completed);  ///< takes back batches that the device is done with
    std::uint64_t open_value() const;       ///< the timeline's value for the open batch

private:
    void open() override;
    void recorded() override;
    void staged(std::uint64_t bytes) override;
    Query take_query() override;
    void note_times(TimedWork times) override;
    void open_batch();
    std::shared_ptr<DownloadObject> ticket(const Slice& slice, std::uint64_t bytes);

    std::unique_ptr<CommandBatch> batch_;
    std::deque<std::unique_ptr<CommandBatch>> in_flight_;
    bool ends_in_download_ = false;   ///< the next command other than a download opens a new batch
    std::uint64_t staged_bytes_ = 0;  ///< bytes of staging that uploads took; a submission resets it
};

template <class Submission> void ImmediateStream::timed(const Work& work, Submission&& submission) {
    open();
    std::optional<TimedWork> times;
    begin_marked(work, times);
    encoder_.labels().end(encoder_.commands());  // a label that is open during submissions would hold their labels
    submit();
    submission();
    open();
    encoder_.labels().begin(encoder_.commands(), work.name);
    end_marked(times);
}

}  // namespace glift::detail
