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

/// Holds the memories that its passes use. Parameters are those of the moment of recording; device values (patches,
/// indirect sizes) are read anew by each replay.
class GLIFT_API Recording {
public:
    Recording() = default;
    explicit Recording(std::shared_ptr<detail::RecordingObject> object) : object_(std::move(object)) {}

    /// One submission, in order with the device's own stream; may be called again at once.
    void submit() const;

private:
    std::shared_ptr<detail::RecordingObject> object_;
};

namespace detail {
GLIFT_API Commands begin_recording(const Device& device);
GLIFT_API Recording end_recording(const Commands& commands);
}  // namespace detail

template <class Body> Recording Device::record(Body&& body) const {
    const Commands commands = detail::begin_recording(*this);
    body(commands);
    return detail::end_recording(commands);
}

}  // namespace glift
