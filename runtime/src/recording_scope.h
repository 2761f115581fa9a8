// What "the device's stream" means within the body of a recording.
#pragma once

#include "objects.h"

namespace glift::detail {

/// The device's own stream or, within a body of Device::record or Device::workspace_bytes on this thread, the one that
/// the body's commands go to.
std::shared_ptr<Stream> stream_of(const std::shared_ptr<DeviceObject>& device);

/// Throws wrong_argument within such a body.
void require_no_recording(const DeviceObject& device, const char* call);

}  // namespace glift::detail
