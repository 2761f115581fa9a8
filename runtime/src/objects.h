// Interfaces of the objects behind the public handles, implemented in vulkan/ and host/.
#pragma once

#include "messages.h"
#include "profile/profiler.h"
#include "workspace.h"

#include <glift/commands.h>
#include <glift/device.h>
#include <glift/memory.h>
#include <glift/recording.h>

#include <atomic>
#include <functional>
#include <optional>
#include <string>

namespace glift::detail {

/// Which levels and layers (faces) of an image a part of it covers.
struct Texels {
    std::uint32_t mip = 0, mips = 1, layer = 0, layers = 1;
    bool operator==(const Texels&) const = default;
};

class MemoryObject : public std::enable_shared_from_this<MemoryObject> {
public:
    MemoryObject(std::shared_ptr<DeviceObject> device, const MemoryDescription& description);
    virtual ~MemoryObject() = default;
    MemoryObject(const MemoryObject&) = delete;

    const MemoryDescription& description() const { return description_; }
    const std::shared_ptr<DeviceObject>& device() const { return device_; }

    /// Notes that the container whose memory this was has other memory now: recordings that use this one can no longer
    /// be submitted, and calls that are given it throw.
    void note_replaced() { (whole_ ? whole_->is_replaced_ : is_replaced_) = true; }
    bool is_replaced() const { return whole_ ? whole_->is_replaced_ : is_replaced_; }

    /// The image that this is a part of; null: this is no part.
    const std::shared_ptr<MemoryObject>& whole() const { return whole_; }
    const Texels& texels() const { return texels_; }
    /// Makes a part of this image, which must not be a part itself.
    virtual std::shared_ptr<MemoryObject> part(const MemoryDescription& description, const Texels& texels) = 0;

protected:
    /// Makes a part of `whole`.
    MemoryObject(std::shared_ptr<MemoryObject> whole, const MemoryDescription& description, const Texels& texels);

private:
    std::shared_ptr<DeviceObject> device_;
    std::string name_;
    MemoryDescription description_;
    std::atomic<bool> is_replaced_{false};
    std::shared_ptr<MemoryObject> whole_;
    Texels texels_;
};

/// Whether two memories are one, are an image and a part of it, or are parts of one image that have a level and a layer
/// in common.
bool shares_texels(const MemoryObject* one, const MemoryObject* other);

class DownloadObject {
public:
    virtual ~DownloadObject() = default;
    virtual bool ready() = 0;
    virtual std::span<const std::byte> get() = 0;
};

class TimestampObject {
public:
    virtual ~TimestampObject() = default;
    virtual double seconds() = 0;
};

class RecordingObject {
public:
    virtual ~RecordingObject() = default;
    virtual DeviceObject& device() const = 0;
    virtual void submit() = 0;
    virtual std::uint64_t workspace_bytes() const = 0;
};

/// The end of some commands of a device.
class PointObject {
public:
    virtual ~PointObject() = default;
    /// Returns when the device is done with the commands; the host then sees what they wrote. Any thread may call it.
    virtual void wait() = 0;
};

/// Holds back the commands of a device that are given after it was made.
class GateObject {
public:
    virtual ~GateObject() = default;  ///< opens the gate
    /// The commands may begin; they see what the host has written. Any thread may call it.
    virtual void open() = 0;
};

/// Memory of the host that a link copies from and to.
class AttachedObject {
public:
    virtual ~AttachedObject() = default;
};

/// Copies between a device's memory and the host's beside the commands of the device's stream, which has to be done
/// with what is copied. One thread at a time may copy.
class LinkObject {
public:
    virtual ~LinkObject() = default;
    /// A buffer that the link can copy, and the device's commands can use; its contents start undefined.
    virtual Memory allocate(const MemoryDescription& description) = 0;
    /// Bytes from the beginning of a page of the host's memory on, to the end of a page; they outlive the result.
    virtual std::shared_ptr<AttachedObject> attach(std::span<std::byte> bytes) = 0;
    /// These return when the bytes have been copied.
    virtual void fetch(const Memory& from, AttachedObject& to, std::span<const CopyRegion> regions) = 0;
    virtual void put(AttachedObject& from, const Memory& to, std::span<const CopyRegion> regions) = 0;
};

/// A buffer that the device and the host see.
struct VisibleMemory {
    Memory memory;
    std::span<std::byte> bytes;
};

/// Arguments are checked before they get here (check.h), except for those of `dispatch` and `can_be_direct`, which the
/// streams that run or record check themselves.
class Stream {
public:
    virtual ~Stream() = default;
    virtual std::shared_ptr<DeviceObject> device() = 0;
    /// Allocates a memory for commands of this stream; the description is checked and complete.
    virtual Memory allocate(const MemoryDescription& description);
    virtual bool can_be_direct(const Kernel& kernel, std::span<const Memory> memories,
                               const std::array<std::uint32_t, 4>& size, Sharing sharing) = 0;
    /// Fills with zeros: buffers, and images of any kind.
    virtual void clear(const Memory& memory) = 0;
    /// Whether commands put here may run more than once, or out of order with the device's own stream.
    virtual bool is_recording() const { return false; }
    virtual void dispatch(const Kernel& kernel, const Call& call) = 0;
    virtual void fill(const Memory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value) = 0;
    virtual void fill_where(const Memory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value,
                            std::span<const Condition> conditions) = 0;
    virtual void copy(const Memory& from, const Memory& to, std::span<const CopyRegion> regions) = 0;
    virtual void copy_to_image(const Memory& buffer, const Memory& image, std::span<const ImageRegion> regions) = 0;
    virtual void copy_from_image(const Memory& image, const Memory& buffer, std::span<const ImageRegion> regions) = 0;
    virtual void copy_images(const Memory& from, const Memory& to, std::span<const ImageCopyRegion> regions) = 0;
    virtual void upload(const Memory& to, std::span<const CopyRegion> regions, std::span<const std::byte> bytes) = 0;
    /// Uploads to the beginning of a memory bytes that `fill` writes, into staging memory where the device has some.
    using Fill = std::function<void(std::span<std::byte>)>;
    virtual void upload_filled(const Memory& to, std::uint64_t bytes, const Fill& fill);
    virtual void upload_image(const Memory& image, std::span<const ImageRegion> regions,
                              std::span<const std::byte> bytes) = 0;
    virtual std::shared_ptr<DownloadObject> download(const Memory& from, std::span<const CopyRegion> regions,
                                                     std::uint64_t bytes) = 0;
    virtual std::shared_ptr<DownloadObject> download_image(const Memory& image, std::span<const ImageRegion> regions,
                                                           std::uint64_t bytes) = 0;
    virtual std::shared_ptr<TimestampObject> timestamp() = 0;
    virtual void flush() = 0;
    virtual void wait() = 0;

    /// Refuses commands from now on. Safe to call from any thread.
    void close() { closed_ = true; }
    bool is_closed() const { return closed_; }

private:
    std::atomic<bool> closed_{false};
};

/// A device's limits on draws.
struct DrawLimits {
    /// The size of the viewport. At most 16384 along each axis: the limit of the host's rasteriser
    /// (<glift/host/raster.h>).
    uint2 viewport = {16384, 16384};
    /// The size of the whole image (its level 0), even if only a level of it is drawn to.
    uint2 target = {UINT32_MAX, UINT32_MAX};
    std::uint32_t colours = UINT32_MAX;  ///< colour targets
};

class DeviceObject : public std::enable_shared_from_this<DeviceObject> {
public:
    virtual ~DeviceObject() = default;
    virtual const DeviceProperties& properties() const = 0;
    virtual DrawLimits draw_limits() const { return {}; }
    /// Whether commands for this device may use the memory.
    virtual bool reaches(const MemoryObject& memory) const { return memory.device().get() == this; }
    virtual std::shared_ptr<MemoryObject> allocate(const MemoryDescription& description) = 0;
    /// What a memory of this description would need; allocates nothing.
    virtual StorageNeeds storage_needs(const MemoryDescription& description) = 0;
    virtual Stream& stream() = 0;
    /// A buffer that the host sees as well; its contents start undefined.
    virtual VisibleMemory allocate_visible(const MemoryDescription& description) = 0;
    /// Null: the device has none.
    virtual LinkObject* link() { return nullptr; }
    /// Submits the commands that were given to stream() so far, and returns their end. Null: they have run.
    virtual std::shared_ptr<PointObject> point() { return nullptr; }
    /// Whether commands can be held back. If not, the caller waits before it gives them.
    virtual bool has_gates() const { return false; }
    /// Holds back the commands that are given to stream() from now on. Gates have to be opened in the order in which
    /// they were made.
    virtual std::shared_ptr<GateObject> gate() { return nullptr; }
    virtual std::shared_ptr<Stream> begin_recording() = 0;
    virtual std::shared_ptr<RecordingObject> end_recording(Stream& stream) = 0;
    virtual Statistics statistics() = 0;
    virtual std::vector<std::string> validation_messages() = 0;

    Profiler& profiler() { return profiler_; }
    const Profiler& profiler() const { return profiler_; }
    /// Turns the profiler on for one more user. Throws missing_feature where the device cannot tell times.
    virtual void start_profile() { profiler_.turn_on(); }
    /// The time on the clock of the profiler's events; nothing if it cannot be read.
    virtual std::optional<Nanoseconds> now() { return std::nullopt; }
    /// Waits for what was submitted, and gives the profiler what it does not know of yet.
    virtual void finish_profile() {}

    virtual MessageOutlet& messages() { return messages_; }

private:
    Profiler profiler_;
    MessageOutlet messages_;
};

/// The object behind the handle; throws for an empty one.
const std::shared_ptr<DeviceObject>& shared_device(const Device& device, const char* call);

}  // namespace glift::detail
