// Whether a Vulkan device skips branches that no lane takes. Shaders have other code for devices that do.
#pragma once

#include <glift/device.h>

#include <cstdlib>

namespace glift::detail {

/// Whether a branch that no lane takes costs nothing: GPUs skip it, CPUs compute both sides of each. With the
/// environment variable GLIFT_SKIPS_BRANCHES, tests run the GPUs' code on CPUs, too.
inline bool skips_branches(DeviceKind kind) {
    static const bool is_asked_for = std::getenv("GLIFT_SKIPS_BRANCHES") != nullptr;
    return kind != DeviceKind::cpu || is_asked_for;
}

}  // namespace glift::detail
