// Redirects the device's own stream, within a body of Device::record or Device::workspace_bytes, to the stream of the
// body.
#pragma once

#include "objects.h"

namespace glift::detail {

/// The device's own stream or, within a body of Device::record or Device::workspace_bytes on this thread, the body's.
std::shared_ptr<Stream> stream_of(const std::shared_ptr<DeviceObject>& device);

/// Throws wrong_argument within such a body.
void require_no_recording(const DeviceObject& device, const char* call);

}  // namespace glift::detail
