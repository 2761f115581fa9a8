#include "measuring.h"

#include <glift/error.h>

namespace glift::detail {

namespace {

[[noreturn]] void throw_needs_to_run(const char* call) {
    throw Error(ErrorCode::wrong_argument, "the workspace cannot be known before the commands run", call,
                "Device::workspace_bytes runs nothing, and what follows depends on a value of the device (await)",
                "ask for the parts before and after it, or record them: Recording::workspace_bytes");
}

/// Plans allocations and ignores commands; throws where the host would wait for the device or read a value of it.
class MeasuringStream final : public Stream {
public:
    explicit MeasuringStream(MeasuringDevice& device) : device_(device) {}

    std::shared_ptr<DeviceObject> device() override { return device_.shared_from_this(); }
    Memory allocate(const MemoryDescription& description) override { return device_.plan(description); }
    bool can_be_direct(const Kernel&, std::span<const Memory>, const std::array<std::uint32_t, 4>&, Sharing) override {
        return true;
    }
    void clear(const Memory&) override {}
    void dispatch(const Kernel&, const Call&) override {}
    void fill(const Memory&, std::uint64_t, std::uint64_t, std::uint32_t) override {}
    void fill_where(const Memory&, std::uint64_t, std::uint64_t, std::uint32_t, std::span<const Condition>) override {}
    void copy(const Memory&, const Memory&, std::span<const CopyRegion>) override {}
    void copy_to_image(const Memory&, const Memory&, std::span<const ImageRegion>) override {}
    void copy_from_image(const Memory&, const Memory&, std::span<const ImageRegion>) override {}
    void copy_images(const Memory&, const Memory&, std::span<const ImageCopyRegion>) override {}
    void upload(const Memory&, std::span<const CopyRegion>, std::span<const std::byte>) override {}
    void upload_image(const Memory&, std::span<const ImageRegion>, std::span<const std::byte>) override {}
    std::shared_ptr<DownloadObject> download(const Memory&, std::span<const CopyRegion>, std::uint64_t) override {
        throw_needs_to_run("Commands::download");
    }
    std::shared_ptr<DownloadObject> download_image(const Memory&, std::span<const ImageRegion>,
                                                   std::uint64_t) override {
        throw_needs_to_run("Commands::download_image");
    }
    std::shared_ptr<TimestampObject> timestamp() override { throw_needs_to_run("Commands::timestamp"); }
    void flush() override {}
    void wait() override { throw_needs_to_run("Commands::wait"); }

private:
    MeasuringDevice& device_;
};

/// A memory that counts in the workspace but has no storage.
class PlannedMemory final : public MemoryObject {
public:
    using MemoryObject::MemoryObject;
    PlannedMemory(std::shared_ptr<MemoryObject> whole, const MemoryDescription& description, const Texels& texels)
        : MemoryObject(std::move(whole), description, texels) {}

    std::shared_ptr<MemoryObject> part(const MemoryDescription& description, const Texels& texels) override {
        return std::make_shared<PlannedMemory>(shared_from_this(), description, texels);
    }
};

}  // namespace

MeasuringDevice::MeasuringDevice(std::shared_ptr<DeviceObject> real)
    : real_(std::move(real)), stream_(std::make_unique<MeasuringStream>(*this)) {}

MeasuringDevice::~MeasuringDevice() = default;

Memory MeasuringDevice::plan(const MemoryDescription& description) {
    auto memory = std::make_shared<PlannedMemory>(shared_from_this(), description);
    const StorageNeeds needs = real_->storage_needs(description);
    if (needs.shares) return temporary(std::move(memory), workspace_, workspace_->take(needs));
    workspace_->add(needs.bytes);
    return Memory(std::move(memory));
}

std::shared_ptr<MemoryObject> MeasuringDevice::allocate(const MemoryDescription& description) {
    return plan(description).share();
}

StorageNeeds MeasuringDevice::storage_needs(const MemoryDescription& description) {
    return real_->storage_needs(description);
}

VisibleMemory MeasuringDevice::allocate_visible(const MemoryDescription&) { throw_needs_to_run("allocate_visible"); }
std::shared_ptr<Stream> MeasuringDevice::begin_recording() { throw_needs_to_run("Device::record"); }
std::shared_ptr<RecordingObject> MeasuringDevice::end_recording(Stream&) { throw_needs_to_run("Device::record"); }

}  // namespace glift::detail
