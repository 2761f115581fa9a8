// Whether shaders have code of their own where a branch is worth it.
#pragma once

#include <glift/device.h>

#include <cstdlib>

namespace glift::detail {

/// Whether a branch that no lane takes costs nothing: GPUs skip it, CPUs compute both sides of each. Tests run what
/// GPUs run: GLIFT_SKIPS_BRANCHES.
inline bool skips_branches(DeviceKind kind) {
    static const bool is_asked_for = std::getenv("GLIFT_SKIPS_BRANCHES") != nullptr;
    return kind != DeviceKind::cpu || is_asked_for;
}

}  // namespace glift::detail
