// The host device: kernels are compiled C++, memory is plain bytes, commands run synchronously.
#pragma once

#include "../objects.h"

namespace glift::detail {

std::shared_ptr<DeviceObject> open_host_device();

}  // namespace glift::detail
