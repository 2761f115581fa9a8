// Checks of a draw's targets, the same for every device. Throws wrong_argument, aliased_memory or too_large.
#pragma once

#include <glift/commands.h>

namespace glift::detail {

void check_draw(const DeviceObject* device, const Kernel& kernel, const Call& call);

}  // namespace glift::detail
