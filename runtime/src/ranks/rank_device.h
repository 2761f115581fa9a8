// The device of a World: commands for it are distributed over the ranks.
#pragma once

#include "rank_stream.h"

namespace glift::detail {

/// Has the properties and the memories of this rank's own device.
class RankDevice final : public DeviceObject {
public:
    RankDevice(std::shared_ptr<ranks::Transport> transport, std::shared_ptr<DeviceObject> local,
               const ranks::Options& options);

    const DeviceProperties& properties() const override { return local_->properties(); }
    DrawLimits draw_limits() const override { return local_->draw_limits(); }
    bool reaches(const MemoryObject& memory) const override { return local_->reaches(memory); }
    std::shared_ptr<MemoryObject> allocate(const MemoryDescription& description) override {
        return local_->allocate(description);
    }
    StorageNeeds storage_needs(const MemoryDescription& description) override {
        return local_->storage_needs(description);
    }
    Stream& stream() override { return stream_; }
    VisibleMemory allocate_visible(const MemoryDescription& description) override {
        return local_->allocate_visible(description);
    }
    std::shared_ptr<Stream> begin_recording() override;
    std::shared_ptr<RecordingObject> end_recording(Stream& stream) override;
    glift::Statistics statistics() override { return local_->statistics(); }
    std::vector<std::string> validation_messages() override { return local_->validation_messages(); }
    MessageOutlet& messages() override { return local_->messages(); }

    RankStream& ranks() { return stream_; }

private:
    std::shared_ptr<DeviceObject> local_;
    RankStream stream_;
};

}  // namespace glift::detail
