// A device that runs nothing: it computes how large the workspace (workspace.h) of a recording of the same commands
// would be.
#pragma once

#include "objects.h"

namespace glift::detail {

/// Has the properties of the real device. Memories allocated on it count in a workspace, as in a recording, but get no
/// storage; commands are ignored, except that downloads, timestamps, waits and recordings throw.
class MeasuringDevice final : public DeviceObject {
public:
    explicit MeasuringDevice(std::shared_ptr<DeviceObject> real);
    ~MeasuringDevice() override;

    std::uint64_t workspace_bytes() const { return workspace_->bytes(); }
    Memory plan(const MemoryDescription& description);

    const DeviceProperties& properties() const override { return real_->properties(); }
    bool reaches(const MemoryObject& memory) const override {
        return DeviceObject::reaches(memory) || real_->reaches(memory);
    }
    std::shared_ptr<MemoryObject> allocate(const MemoryDescription& description) override;
    StorageNeeds storage_needs(const MemoryDescription& description) override;
    Stream& stream() override { return *stream_; }
    VisibleMemory allocate_visible(const MemoryDescription& description) override;
    std::shared_ptr<Stream> begin_recording() override;
    std::shared_ptr<RecordingObject> end_recording(Stream& stream) override;
    Statistics statistics() override { return real_->statistics(); }
    std::vector<std::string> validation_messages() override { return {}; }

private:
    std::shared_ptr<DeviceObject> real_;
    std::shared_ptr<Workspace> workspace_ = std::make_shared<Workspace>();
    std::unique_ptr<Stream> stream_;
};

}  // namespace glift::detail
