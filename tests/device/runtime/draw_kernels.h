// Hand-written kernels that draw, in the form that gliftc generates.
#pragma once

#include "kernels.h"

namespace kernels {

struct Corner {
    float place[4];
    float colour[4];
};

struct DrawParameters {
    std::uint32_t corners, instances;
    float shift;  ///< how far each instance is shifted to the right of the one before, in half widths of the viewport
    std::uint32_t unused = 0;
    std::uint64_t addresses[2] = {};  ///< filled in by the runtime
};

/// All have the general form only. Bindings: the corners, and a count of fragments; they write colour to an rgba32f
/// image. draw_replacing and draw_culled test depth (less) and write it; draw_culled culls back faces; draw_over blends
/// and has no depth.
extern const glift::Kernel draw_replacing, draw_over, draw_culled;

}  // namespace kernels
