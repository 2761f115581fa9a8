// Compares the device times of a case's generated and hand-written passes.
#pragma once

#include "cases.h"

namespace bench {

struct Measured {
    double generated = 0, handwritten = 0;  ///< median seconds of one pass
    double ratio = 0;                       ///< median of the runs' ratios
    bool agree = false;                     ///< both wrote the same bytes
};

/// Times `runs` pairs of the two passes; which goes first alternates. In a run each is repeated for about `seconds`, at
/// most 400 times.
Measured measure(const glift::Device& device, const Case& one, int runs, double seconds);

}  // namespace bench
