// A device that keeps the shader of the last compute pipeline that was made, as the driver got it: it intercepts Vulkan
// functions.
#pragma once

#include "instructions.h"

#include <glift/glift.h>

namespace bench {

/// Makes a second device over the Vulkan device of `device`, which has to outlive it.
glift::Device spy_on(const glift::Device& device);

/// The shader of the last compute pipeline that such a device made, with the values of its specialisation constants.
/// Parameters that a specialised call fixed are constants in it.
Shader last_shader();

}  // namespace bench
