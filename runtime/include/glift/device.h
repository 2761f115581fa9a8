// A device: a GPU, a CPU that runs Vulkan (lavapipe), or the host, which runs the kernels as compiled C++.
#pragma once

#include <glift/handle.h>
#include <glift/memory.h>
#include <glift/message.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace glift {

class Commands;
class Recording;
namespace detail {
class DeviceObject;
}

enum class DeviceKind : std::uint8_t { gpu, cpu, host };  ///< cpu: Vulkan on the CPU

/// No limit.
inline constexpr std::uint64_t unlimited = UINT64_MAX;

struct DeviceProperties {
    std::string name;    ///< `NVIDIA H200`, `llvmpipe (LLVM 15.0.6, 256 bits)`, `host`
    std::string driver;  ///< name and version of the driver; host: `compiled C++`
    DeviceKind kind = DeviceKind::host;
    /// Of every kernel that uses subgroups. A device that allows several sizes runs such kernels with this one; if it
    /// cannot be told to, this is 1, the subgroup operations below are false, and such kernels are refused.
    std::uint32_t subgroup_size = 1;
    std::uint64_t memory_bytes = 0;                  ///< of the largest heap of device memory; host: of the machine
    std::uint64_t max_allocation_bytes = unlimited;  ///< of one buffer; an image may be limited to less
    /// The largest buffer that a descriptor covers. Kernels reach larger ones by their general form (kernel.h).
    std::uint64_t max_storage_buffer_range = unlimited;
    std::uint32_t shared_memory_bytes = 0;  ///< of a workgroup; kernels that declare more are refused (too_large)
    std::uint32_t max_push_constant_bytes = 128;
    std::array<std::uint32_t, 3> max_workgroups = {UINT32_MAX, UINT32_MAX, UINT32_MAX};
    std::array<std::uint32_t, 3> max_workgroup_size = {1024, 1024, 64};
    std::uint32_t max_workgroup_invocations = 1024;
    /// Iterations, summed over all loops of an invocation, after which the device leaves the invocation's loops.
    std::uint64_t loop_round_limit = unlimited;
    /// Acquire and release fences act as barriers of the workgroup: if only some of its subgroups reach one, the device
    /// ends the others without an error.
    bool fences_are_barriers = false;
    /// Helper invocations (pixels beside a triangle, which take part in derivatives) load from buffers and storage
    /// images; false: they load zeros.
    bool helpers_load = true;
    double timestamp_seconds = 1e-9;  ///< length of a tick of the device's clock
    bool int8 = false, int16 = false, int64 = false, float16 = false, float64 = false;
    bool int64_atomics = false;
    bool float32_atomic_add = false;      ///< on buffers and workgroup memory
    bool float32_atomic_min_max = false;  ///< on buffers
    bool image_float32_atomic_add = false;
    bool subgroup_vote = false, subgroup_arithmetic = false, subgroup_ballot = false;  ///< in compute shaders
    bool subgroup_shuffle = false, subgroup_shuffle_relative = false;                  ///< in compute shaders
    bool subgroup_extended_types = false;  ///< subgroup operations take integers of 8, 16, 64 bits and halfs, too
    bool descriptor_indexing = false;
    bool push_descriptors = false;
};

/// Counted since the device was opened; memories and bytes are current values. The host device counts only passes,
/// memories and bytes.
struct Statistics {
    std::uint64_t submissions = 0;
    /// Calls of kernels; those in a recording count at each replay, those of record_into (vulkan.h) once. The host
    /// device leaves out calls whose conditions do not hold.
    std::uint64_t passes = 0;
    std::uint64_t barriers = 0;    ///< recorded between passes and copies (a replay counts none)
    std::uint64_t pipelines = 0;   ///< created for kernels
    std::uint64_t waits = 0;       ///< calls of wait and Download::get, and the first seconds() of each Timestamp
    std::uint64_t memories = 0;    ///< whose storage is not freed yet; host: parts of images count, too
    std::uint64_t bytes_used = 0;  ///< by memories, staging and parameters
    /// Taken from the device, in blocks. Blocks that are free are kept for new memories: up to an eighth of the
    /// device's memory, on CPUs a thirty-second.
    std::uint64_t bytes_reserved = 0;
};

/// A cheap handle: copies mean the same device. Several threads may use a device at the same time.
class GLIFT_API Device {
public:
    /// `host`, in lower case; or, in upper or lower case, `gpu`, `lavapipe` or part of a device's name; `gpu:1` is the
    /// second of those that fit, best first. Without an argument the environment variable GLIFT_DEVICE decides; without
    /// that, the best GPU, else a CPU that runs Vulkan, which is logged once (log.h). Never the host unless `host` is
    /// given. Throws no_loader, no_device, unsupported_version, missing_feature, missing_layer, or wrong_argument for
    /// an environment variable with an invalid value.
    ///
    /// Other environment variables: GLIFT_VALIDATE=1 turns on the validation layer; GLIFT_CACHE_DIR says where
    /// compiled pipelines are kept (default: $XDG_CACHE_HOME/glift or ~/.cache/glift; empty: nowhere);
    /// GLIFT_MEMORY_LIMIT caps the bytes taken from the device (`500000`, `64K`, `512M`, `2G`, `1T`: powers of 1024);
    /// GLIFT_VULKAN_LOADER names the loader library; GLIFT_QUIET=1 silences messages (log.h).
    static Device open(std::string_view which = {});

    Device() = default;  ///< an empty handle
    explicit Device(std::shared_ptr<detail::DeviceObject> object) : object_(std::move(object)) {}
    explicit operator bool() const { return bool(object_); }

    const DeviceProperties& properties() const;
    bool is_host() const { return properties().kind == DeviceKind::host; }

    /// Throws out_of_memory or too_large, with the sizes; missing_feature for an image of a kind or format that the
    /// device does not have; wrong_argument for a description that contradicts itself.
    Memory allocate(const MemoryDescription& description) const;

    /// The device's own stream: everything put there happens in order. Within a body of `record` or
    /// `workspace_bytes`, on the thread that runs it, this is the body's stream. See commands.h.
    Commands commands() const;

    /// Captures what body(const Commands&) does, to be submitted any number of times. See recording.h.
    template <class Body> Recording record(Body&& body) const;

    /// The bytes of temporary memory that a recording of what body(const Commands&) does would take: what
    /// Recording::workspace_bytes() of that recording returns. Nothing is allocated and nothing runs: in the body,
    /// structures made from its Commands have no storage. So it throws wrong_argument where the body waits for the
    /// device or reads from it (`await` in a pipeline, downloads, timestamps). See recording.h.
    template <class Body> std::uint64_t workspace_bytes(Body&& body) const;

    void wait() const;  ///< Commands::wait of the device's own stream
    Statistics statistics() const;

    /// What the validation layer said (errors and warnings about correctness, none about speed), since the last call.
    std::vector<std::string> validation_messages() const;

    /// What kernels print goes to `sink` from now on; an empty function silences them. Returns the previous function;
    /// at first messages are written to stderr, one a line. They arrive when the host waits for the device (wait,
    /// Download::get, Timestamp::seconds), on the host device at the end of each pass, and when the device is
    /// destroyed. After a failed assertion the call that waits throws assertion_failed; no invocation is stopped. The
    /// buffer has 1 MiB, or the bytes that the environment variable GLIFT_PRINT_BYTES says.
    MessageSink on_message(MessageSink sink) const;

    bool operator==(const Device&) const = default;
    const std::shared_ptr<detail::DeviceObject>& share() const { return object_.share(); }

private:
    detail::Held<detail::DeviceObject> object_;
};

}  // namespace glift
