// Redirects the device's own stream, within a body of Device::record or Device::workspace_bytes, to the stream of the
// body.
#include "recording_scope.h"

#include "report.h"

#include <glift/recording.h>

#include <algorithm>
#include <vector>

namespace glift::detail {

namespace {

struct Redirection {
    const DeviceObject* device;
    std::shared_ptr<Stream> stream;
};

/// The redirections by the bodies that run on this thread, innermost last.
thread_local std::vector<Redirection> redirections;

}  // namespace

RecordingScope::RecordingScope(const Device& device, const Commands& commands) {
    redirections.push_back({device.share().get(), commands.share()});
}

RecordingScope::~RecordingScope() {
    redirections.back().stream->close();
    redirections.pop_back();
}

std::shared_ptr<Stream> stream_of(const std::shared_ptr<DeviceObject>& device) {
    const auto found = std::find_if(redirections.rbegin(), redirections.rend(),
                                    [&](const Redirection& r) { return r.device == device.get(); });
    if (found != redirections.rend()) return found->stream;
    return {device, &device->stream()};
}

void require_no_recording(const DeviceObject& device, const char* call) {
    const auto is_its = [&](const Redirection& r) { return r.device == &device; };
    if (std::any_of(redirections.begin(), redirections.end(), is_its)) throw_not_in_recording(call);
}

}  // namespace glift::detail
