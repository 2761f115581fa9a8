// Hand-written kernels that draw, in the form that gliftc emits.
#pragma once

#include "kernels.h"

namespace kernels {

struct Corner {
    float place[4];
    float colour[4];
};

struct DrawParameters {
    std::uint32_t corners, instances;
    float shift;  ///< of instance 1, in the window's half widths
};

/// general; corners, counts; colour into rgba32f, depth less and written; back faces culled where its name says so.
extern const glift::Kernel draw_replacing, draw_over, draw_culled;

}  // namespace kernels
