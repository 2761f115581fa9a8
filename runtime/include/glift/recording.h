// Passes recorded once and submitted many times.
#pragma once

#include <glift/api.h>
#include <glift/commands.h>
#include <glift/device.h>

#include <memory>

namespace glift {

namespace detail {
class RecordingObject;
}

/// A finished recording. Keeps the memories alive that its commands use. Memories that were made by its Commands, such
/// as temporaries of pipelines, lie in its workspace: where the last handle of one is gone before another is made, the
/// two may share storage (on Vulkan devices only buffers do: each image has its own). Parameters are captured when
/// recorded; values that lie on the device (sizes, arguments, conditions) are read anew by each replay.
class GLIFT_API Recording {
public:
    Recording() = default;
    explicit Recording(std::shared_ptr<detail::RecordingObject> object) : object_(std::move(object)) {}
    explicit operator bool() const { return bool(object_); }

    /// One submission, in order with the device's own stream; may be called again at once. Throws wrong_argument where
    /// a container has given up memory that the recording uses, and in a body of Device::record or
    /// Device::workspace_bytes of the same device.
    void submit() const;

    /// The size of the workspace in bytes.
    std::uint64_t workspace_bytes() const;

private:
    detail::Held<detail::RecordingObject> object_;
};

namespace detail {
GLIFT_API Commands begin_recording(const Device& device);
GLIFT_API Recording end_recording(const Commands& commands);
GLIFT_API Device begin_measuring(const Device& device);
GLIFT_API std::uint64_t measured_bytes(const Device& measuring);

/// The scope of a body of Device::record or Device::workspace_bytes: this thread's commands to the device go into
/// `commands`, which accept no more when the scope ends.
class GLIFT_API RecordingScope {
public:
    RecordingScope(const Device& device, const Commands& commands);
    ~RecordingScope();
    RecordingScope(const RecordingScope&) = delete;
    RecordingScope& operator=(const RecordingScope&) = delete;
};
}  // namespace detail

template <class Body> Recording Device::record(Body&& body) const {
    const Commands commands = detail::begin_recording(*this);
    const detail::RecordingScope scope(*this, commands);
    body(commands);
    return detail::end_recording(commands);
}

template <class Body> std::uint64_t Device::workspace_bytes(Body&& body) const {
    const Device measuring = detail::begin_measuring(*this);
    const Commands commands = measuring.commands();
    const detail::RecordingScope scope(*this, commands);
    body(commands);
    return detail::measured_bytes(measuring);
}

}  // namespace glift
