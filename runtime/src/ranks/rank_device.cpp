#include "rank_device.h"

#include <glift/error.h>

namespace glift::detail {

namespace {

[[noreturn]] void throw_no_recording() {
    throw Error(ErrorCode::wrong_argument, "a device of several ranks makes no recordings", "Device::record",
                "between passes, the host exchanges elements with other ranks",
                "call the pipelines themselves, or record on World::local_device what uses no distributed structure");
}

}  // namespace

RankDevice::RankDevice(std::shared_ptr<ranks::Transport> transport, std::shared_ptr<DeviceObject> local,
                       const ranks::Options& options)
    : local_(local), stream_(*this, std::move(transport), std::move(local), options) {}

std::shared_ptr<Stream> RankDevice::begin_recording() { throw_no_recording(); }
std::shared_ptr<RecordingObject> RankDevice::end_recording(Stream&) { throw_no_recording(); }

}  // namespace glift::detail
