#include "host_device.h"

#include "../machine_memory.h"
#include "../profile/process_profile.h"
#include "host_link.h"
#include "host_memory.h"
#include "host_stream.h"

#include <chrono>

namespace glift::detail {

namespace {

/// The limit of a workgroup's memory. Its arrays are local variables of the function that runs the workgroup: they lie
/// on the stack of a oneTBB thread, of 4 MiB, together with what the invocations keep across barriers.
constexpr std::uint32_t shared_memory_bytes = 1u << 20;

class HostDevice final : public DeviceObject {
public:
    HostDevice() {
        properties_.name = "host";
        properties_.driver = "compiled C++";
        properties_.kind = DeviceKind::host;
        properties_.memory_bytes = machine_memory_bytes();
        properties_.shared_memory_bytes = shared_memory_bytes;
        properties_.max_push_constant_bytes = UINT32_MAX;
        properties_.int8 = properties_.int16 = properties_.int64 = properties_.float64 = true;
        properties_.int64_atomics = properties_.float32_atomic_add = properties_.float32_atomic_min_max = true;
        properties_.image_float32_atomic_add = true;
        properties_.subgroup_vote = properties_.subgroup_arithmetic = properties_.subgroup_ballot = true;
        properties_.subgroup_shuffle = properties_.subgroup_shuffle_relative = true;
        properties_.subgroup_extended_types = true;
    }

    ~HostDevice() override { keep_profile(*this); }

    const DeviceProperties& properties() const override { return properties_; }

    std::shared_ptr<MemoryObject> allocate(const MemoryDescription& description) override {
        auto storage = std::make_shared<HostStorage>(description.bytes, description, counters_);
        return std::make_shared<HostMemoryObject>(shared_from_this(), description, std::move(storage), 0, counters_);
    }
    VisibleMemory allocate_visible(const MemoryDescription& description) override {
        const Memory memory(allocate(description));
        return {memory, {host_memory(memory).data(), description.bytes}};
    }
    LinkObject* link() override { return &link_; }
    StorageNeeds storage_needs(const MemoryDescription& description) override { return {.bytes = description.bytes}; }

    Stream& stream() override { return stream_; }
    std::shared_ptr<Stream> begin_recording() override {
        return std::make_shared<HostRecordingStream>(*this, counters_);
    }
    std::shared_ptr<RecordingObject> end_recording(Stream& stream) override {
        return static_cast<HostRecordingStream&>(stream).finish();
    }

    std::optional<Nanoseconds> now() override {
        return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
            .count();
    }

    Statistics statistics() override {
        Statistics result;
        result.passes = counters_.passes;
        result.memories = counters_.memories;
        result.bytes_used = result.bytes_reserved = counters_.bytes;
        return result;
    }

    std::vector<std::string> validation_messages() override { return {}; }

private:
    DeviceProperties properties_;
    HostCounters counters_;
    HostStream stream_{*this, counters_};
    HostLink link_{*this};
};

}  // namespace

std::shared_ptr<DeviceObject> open_host_device() { return std::make_shared<HostDevice>(); }

}  // namespace glift::detail
