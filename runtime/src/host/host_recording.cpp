#include "../check.h"
#include "../report.h"
#include "host_stream.h"

namespace glift::detail {

namespace {

template <class T> std::vector<T> copied(std::span<const T> values) { return {values.begin(), values.end()}; }

class HostRecording final : public RecordingObject {
public:
    HostRecording(std::shared_ptr<DeviceObject> device, std::vector<HostStep> steps, std::vector<Memory> held,
                  std::vector<std::shared_ptr<HostStorage>> workspace, std::uint64_t workspace_bytes)
        : device_(std::move(device)), steps_(std::move(steps)), held_(std::move(held)),
          workspace_(std::move(workspace)), workspace_bytes_(workspace_bytes) {}

    DeviceObject& device() const override { return *device_; }
    void submit() override {
        require_current(held_);
        auto& stream = static_cast<HostStream&>(device_->stream());
        const auto lock = stream.lock();
        const Run run = device_->profiler().next_replay();
        for (const HostStep& step : steps_) stream.replay(step.command, step.path, run);
    }
    std::uint64_t workspace_bytes() const override { return workspace_bytes_; }

private:
    std::shared_ptr<DeviceObject> device_;
    std::vector<HostStep> steps_;
    std::vector<Memory> held_;                             ///< memories that the steps use
    std::vector<std::shared_ptr<HostStorage>> workspace_;  ///< the workspace's blocks: workspace_bytes_ in total
    std::uint64_t workspace_bytes_;
};

}  // namespace

Memory HostRecordingStream::held(const Memory& memory) {
    const auto locked = lock();
    Memory result = kept(memory);
    if (held_objects_.insert(result.object()).second) held_.push_back(result);
    return result;
}

std::vector<Memory> HostRecordingStream::held_all(std::span<const Memory> memories) {
    std::vector<Memory> result;
    for (const Memory& memory : memories) result.push_back(held(memory));
    return result;
}

std::vector<Patch> HostRecordingStream::held_all(std::span<const Patch> patches) {
    std::vector<Patch> result(patches.begin(), patches.end());
    for (Patch& patch : result) patch.value.memory = held(patch.value.memory);
    return result;
}

std::vector<Condition> HostRecordingStream::held_all(std::span<const Condition> conditions) {
    std::vector<Condition> result(conditions.begin(), conditions.end());
    for (Condition& condition : result) condition.value.memory = held(condition.value.memory);
    return result;
}

Attachment HostRecordingStream::held(const Attachment& attachment) {
    if (!attachment.memory) return {};
    return {held(attachment.memory), attachment.mip, attachment.face};
}

std::shared_ptr<KeptTargets> HostRecordingStream::held(const DrawTargets& targets) {
    std::vector<Attachment> colours;
    for (const Attachment& colour : targets.colours) colours.push_back(held(colour));
    return std::make_shared<KeptTargets>(std::move(colours), held(targets.depth), targets.origin, targets.extent);
}

void HostRecordingStream::note(std::function<void(HostStream&)> command) {
    const auto held = lock();
    if (is_closed()) throw_closed("Commands");
    Profiler& profiler = device_.profiler();
    steps_.push_back({std::move(command), profiler.is_on() ? profiler.path() : std::vector<PathStep>()});
}

Memory HostRecordingStream::allocate(const MemoryDescription& description) {
    const auto held = lock();
    const Workspace::Place place = workspace_->take(device_.storage_needs(description));
    if (place.is_new_block) blocks_.push_back(std::make_shared<HostStorage>(place.bytes, description, counters_));
    auto object = std::make_shared<HostMemoryObject>(keep_, description, blocks_[place.block], place.offset, counters_);
    return temporary(std::move(object), workspace_, place);
}

void HostRecordingStream::dispatch(const Kernel& kernel, const Call& call) {
    check_call(&device_, kernel, call);
    note([&kernel, form = call.form, memories = held_all(call.memories), parameters = copied(call.parameters),
          size = call.size, patches = held_all(call.patches), sharing = call.sharing,
          conditions = held_all(call.conditions),
          kept_targets = call.targets ? held(*call.targets) : nullptr](HostStream& stream) {
        Call again = {form, memories, parameters, size, patches, {}, sharing, conditions};
        DrawTargets targets;
        if (kept_targets) {
            targets = kept_targets->targets();
            again.targets = &targets;
        }
        stream.dispatch(kernel, again);
    });
}

void HostRecordingStream::fill(const Memory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value) {
    note([=, memory = held(memory)](HostStream& stream) { stream.fill(memory, offset, bytes, value); });
}

void HostRecordingStream::fill_where(const Memory& memory, std::uint64_t offset, std::uint64_t bytes,
                                     std::uint32_t value, std::span<const Condition> conditions) {
    note([=, memory = held(memory), all = held_all(conditions)](HostStream& stream) {
        stream.fill_where(memory, offset, bytes, value, all);
    });
}

void HostRecordingStream::clear(const Memory& memory) {
    note([memory = held(memory)](HostStream& stream) { stream.clear(memory); });
}

void HostRecordingStream::copy(const Memory& from, const Memory& to, std::span<const CopyRegion> regions) {
    note([from = held(from), to = held(to), r = copied(regions)](HostStream& stream) { stream.copy(from, to, r); });
}

void HostRecordingStream::copy_to_image(const Memory& buffer, const Memory& image,
                                        std::span<const ImageRegion> regions) {
    note([buffer = held(buffer), image = held(image), r = copied(regions)](HostStream& stream) {
        stream.copy_to_image(buffer, image, r);
    });
}

void HostRecordingStream::copy_from_image(const Memory& image, const Memory& buffer,
                                          std::span<const ImageRegion> regions) {
    note([buffer = held(buffer), image = held(image), r = copied(regions)](HostStream& stream) {
        stream.copy_from_image(image, buffer, r);
    });
}

void HostRecordingStream::copy_images(const Memory& from, const Memory& to, std::span<const ImageCopyRegion> regions) {
    note([from = held(from), to = held(to), r = copied(regions)](HostStream& stream) {
        stream.copy_images(from, to, r);
    });
}

void HostRecordingStream::upload(const Memory& to, std::span<const CopyRegion> regions,
                                 std::span<const std::byte> bytes) {
    note([to = held(to), r = copied(regions), b = copied(bytes)](HostStream& stream) { stream.upload(to, r, b); });
}

void HostRecordingStream::upload_image(const Memory& image, std::span<const ImageRegion> regions,
                                       std::span<const std::byte> bytes) {
    note([image = held(image), r = copied(regions), b = copied(bytes)](HostStream& stream) {
        stream.upload_image(image, r, b);
    });
}

std::shared_ptr<DownloadObject> HostRecordingStream::download(const Memory&, std::span<const CopyRegion>,
                                                              std::uint64_t) {
    throw_not_in_recording("Commands::download");
}

std::shared_ptr<DownloadObject> HostRecordingStream::download_image(const Memory&, std::span<const ImageRegion>,
                                                                    std::uint64_t) {
    throw_not_in_recording("Commands::download_image");
}

std::shared_ptr<TimestampObject> HostRecordingStream::timestamp() { throw_not_in_recording("Commands::timestamp"); }
void HostRecordingStream::flush() { throw_not_in_recording("Commands::flush"); }
void HostRecordingStream::wait() { throw_not_in_recording("Commands::wait"); }

std::shared_ptr<RecordingObject> HostRecordingStream::finish() {
    const auto held = lock();
    close();
    return std::make_shared<HostRecording>(keep_, std::move(steps_), std::move(held_), std::move(blocks_),
                                           workspace_->bytes());
}

}  // namespace glift::detail
