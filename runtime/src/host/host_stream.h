// Streams of the host device: one that runs commands at once, one that records them.
#pragma once

#include "host_memory.h"
#include "host_targets.h"

#include <functional>
#include <mutex>
#include <unordered_set>
#include <vector>

namespace glift::detail {

/// Runs each command before the call returns. A lock serialises commands of several threads.
class HostStream : public Stream {
public:
    HostStream(DeviceObject& device, HostCounters& counters) : device_(device), counters_(counters) {}

    std::shared_ptr<DeviceObject> device() override { return device_.shared_from_this(); }
    bool can_be_direct(const Kernel& kernel, std::span<const Memory> memories, const std::array<std::uint32_t, 4>& size,
                       Sharing sharing) override;
    void dispatch(const Kernel& kernel, const Call& call) override;
    void fill(const Memory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value) override;
    void fill_where(const Memory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value,
                    std::span<const Condition> conditions) override;
    void clear(const Memory& memory) override;
    void copy(const Memory& from, const Memory& to, std::span<const CopyRegion> regions) override;
    void copy_to_image(const Memory& buffer, const Memory& image, std::span<const ImageRegion> regions) override;
    void copy_from_image(const Memory& image, const Memory& buffer, std::span<const ImageRegion> regions) override;
    void copy_images(const Memory& from, const Memory& to, std::span<const ImageCopyRegion> regions) override;
    void upload(const Memory& to, std::span<const CopyRegion> regions, std::span<const std::byte> bytes) override;
    void upload_image(const Memory& image, std::span<const ImageRegion> regions,
                      std::span<const std::byte> bytes) override;
    std::shared_ptr<DownloadObject> download(const Memory& from, std::span<const CopyRegion> regions,
                                             std::uint64_t bytes) override;
    std::shared_ptr<DownloadObject> download_image(const Memory& image, std::span<const ImageRegion> regions,
                                                   std::uint64_t bytes) override;
    std::shared_ptr<TimestampObject> timestamp() override;
    void flush() override {}
    void wait() override { device_.messages().throw_failed(); }

    /// Keeps other threads' commands from running as long as the result lives.
    std::unique_lock<std::recursive_mutex> lock() { return std::unique_lock(mutex_); }

    /// Runs a command of a recording that is submitted.
    void replay(const std::function<void(HostStream&)>& command, const std::vector<PathStep>& path, Run run);

protected:
    DeviceObject& device_;
    HostCounters& counters_;

private:
    struct Replayed {
        const std::vector<PathStep>& path;  ///< the pipelines in which the command was recorded
        Run run;
    };

    /// Runs `body`. If the device is profiled, notes how long that took, of what work() returns.
    template <class MakeWork, class Body> void timed(MakeWork&& work, Body&& body);

    const Replayed* replayed_ = nullptr;  ///< the lock is held where this is not null

    /// Runs the kernel, and delivers what it prints.
    void run(const Kernel& kernel, const Form& form, HostCall& call);

    std::vector<MessageHeader> messages_;  ///< the buffer of messages: a header, and words in the place of others
    /// Recursive: submitting a recording holds the lock while the steps run, and each step takes it again.
    std::recursive_mutex mutex_;
};

/// A recorded command.
struct HostStep {
    std::function<void(HostStream&)> command;
    std::vector<PathStep> path;  ///< the pipelines in which it was recorded; empty if the device was not profiled
};

/// Records commands with copies of their arguments, except for kernels, which it refers to (kernel.h).
class HostRecordingStream final : public HostStream {
public:
    HostRecordingStream(DeviceObject& device, HostCounters& counters)
        : HostStream(device, counters), keep_(device.shared_from_this()) {}

    void dispatch(const Kernel& kernel, const Call& call) override;
    void fill(const Memory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value) override;
    Memory allocate(const MemoryDescription& description) override;
    void fill_where(const Memory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value,
                    std::span<const Condition> conditions) override;
    void clear(const Memory& memory) override;
    bool is_recording() const override { return true; }
    void copy(const Memory& from, const Memory& to, std::span<const CopyRegion> regions) override;
    void copy_to_image(const Memory& buffer, const Memory& image, std::span<const ImageRegion> regions) override;
    void copy_from_image(const Memory& image, const Memory& buffer, std::span<const ImageRegion> regions) override;
    void copy_images(const Memory& from, const Memory& to, std::span<const ImageCopyRegion> regions) override;
    void upload(const Memory& to, std::span<const CopyRegion> regions, std::span<const std::byte> bytes) override;
    void upload_image(const Memory& image, std::span<const ImageRegion> regions,
                      std::span<const std::byte> bytes) override;
    std::shared_ptr<DownloadObject> download(const Memory&, std::span<const CopyRegion>, std::uint64_t) override;
    std::shared_ptr<DownloadObject> download_image(const Memory&, std::span<const ImageRegion>, std::uint64_t) override;
    std::shared_ptr<TimestampObject> timestamp() override;
    void flush() override;
    void wait() override;

    std::shared_ptr<RecordingObject> finish();

private:
    void note(std::function<void(HostStream&)> command);
    Memory held(const Memory& memory);
    std::vector<Memory> held_all(std::span<const Memory> memories);
    std::vector<Patch> held_all(std::span<const Patch> patches);
    std::vector<Condition> held_all(std::span<const Condition> conditions);
    Attachment held(const Attachment& attachment);
    std::shared_ptr<KeptTargets> held(const DrawTargets& targets);

    std::shared_ptr<DeviceObject> keep_;
    std::shared_ptr<Workspace> workspace_ = std::make_shared<Workspace>();
    std::vector<std::shared_ptr<HostStorage>>
        blocks_;  ///< storage of the recording's temporaries; workspace_ says where in which block each lies
    std::vector<HostStep> steps_;
    std::vector<Memory> held_;  ///< memories that the steps use
    std::unordered_set<const MemoryObject*> held_objects_;
};

}  // namespace glift::detail
