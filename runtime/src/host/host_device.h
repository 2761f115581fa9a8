// The host device: kernels as compiled C++, memory as plain bytes, everything done when it is asked for.
#pragma once

#include "../objects.h"

namespace glift::detail {

std::shared_ptr<DeviceObject> open_host_device();

}  // namespace glift::detail
