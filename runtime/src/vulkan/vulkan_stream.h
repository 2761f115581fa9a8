// What the streams of a Vulkan device share: lock, open a command buffer if needed, record, hold what is used.
#pragma once

#include "encoder.h"

namespace glift::detail {

class VulkanStream : public Stream {
public:
    explicit VulkanStream(VulkanDevice& device);

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
    void upload_filled(const Memory& to, std::uint64_t bytes, const Fill& fill) override;
    void upload_image(const Memory& image, std::span<const ImageRegion> regions,
                      std::span<const std::byte> bytes) override;

protected:
    /// Called with the device's lock held.
    virtual void open() = 0;                   ///< before something is recorded
    virtual void recorded() {}                 ///< after a command
    virtual void count_pass();                 ///< after a call of a kernel, however many elements it is for
    virtual void hold(const Memory&) {}        ///< a recorded command uses this memory
    virtual Query take_query() { return {}; }  ///< for a timestamp; none: times are not taken
    virtual void note_times(TimedWork) {}
    virtual void staged(std::uint64_t) {}  ///< after an upload or a part of a large one: its bytes of staging

    /// Records what `encode` does, with a label and timestamps around it where they are wanted. work() says what it is;
    /// it is called only then.
    template <class MakeWork, class Encode> void marked(MakeWork&& work, Encode&& encode);
    void begin_marked(const Work& work, std::optional<TimedWork>& times);
    void end_marked(std::optional<TimedWork>& times);
    bool is_marked() const;

    VulkanDevice& device_;
    Encoder encoder_;
};

template <class MakeWork, class Encode> void VulkanStream::marked(MakeWork&& work, Encode&& encode) {
    if (!is_marked()) return encode();
    std::optional<TimedWork> times;
    begin_marked(work(), times);
    try {
        encode();
    } catch (...) {
        encoder_.labels().end(encoder_.commands());
        throw;
    }
    end_marked(times);
}

/// Records once for many submissions, or into the user's command buffer. Holds every memory that recorded commands use;
/// temporaries with disjoint lifetimes share storage.
class HoldingStream : public VulkanStream {
public:
    explicit HoldingStream(std::shared_ptr<VulkanDevice> device);
    ~HoldingStream() override;

    std::shared_ptr<DeviceObject> device() override;
    bool is_recording() const override { return true; }
    Memory allocate(const MemoryDescription& description) override;
    std::shared_ptr<DownloadObject> download(const Memory&, std::span<const CopyRegion>, std::uint64_t) override;
    std::shared_ptr<DownloadObject> download_image(const Memory&, std::span<const ImageRegion>, std::uint64_t) override;
    std::shared_ptr<TimestampObject> timestamp() override;
    void flush() override;
    void wait() override;

protected:
    void open() override;
    void hold(const Memory& memory) override;

    std::shared_ptr<VulkanDevice> keep_;
    std::unique_ptr<CommandBatch> batch_;
    std::vector<Memory> held_;
    std::vector<bool> held_slots_;
    std::shared_ptr<Workspace> workspace_ = std::make_shared<Workspace>();
    std::vector<std::shared_ptr<VulkanMemory>> blocks_;  ///< of the workspace
};

class RecordingStream final : public HoldingStream {
public:
    explicit RecordingStream(std::shared_ptr<VulkanDevice> device);
    std::shared_ptr<RecordingObject> finish();

private:
    void count_pass() override;  ///< counted again at each submission
    Query take_query() override;
    void note_times(TimedWork times) override;
};

class ExternalStream final : public HoldingStream {
public:
    ExternalStream(std::shared_ptr<VulkanDevice> device, VkCommandBuffer commands);
    void finish();

private:
    void open() override;
    void recorded() override { encoder_.close_labels(); }  // the program may record labels of its own now
};

}  // namespace glift::detail
