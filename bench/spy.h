// A device that keeps the shader of the last pipeline that was made, as the driver got it.
#pragma once

#include "instructions.h"

#include <glift/glift.h>

namespace bench {

/// A second device over the Vulkan device of `device`, which has to live as long.
glift::Device spy_on(const glift::Device& device);

/// The shader of the last compute pipeline that a spy made: with parameters that were fixed, and the values of its
/// specialisation constants.
Shader last_shader();

}  // namespace bench
