// Compares the device times of a case's generated and hand-written passes.
#pragma once

#include "cases.h"

namespace bench {

struct Measured {
    double generated = 0, handwritten = 0;  ///< median seconds of one pass
    double ratio = 0;                       ///< median over the runs of generated / hand-written time
    bool agree = false;                     ///< both wrote the same bytes
};

/// Times `runs` pairs of the two passes; which goes first alternates. In a run both are repeated equally often: so
/// often that the generated pass takes about `seconds` in all, but at most 400 times.
Measured measure(const glift::Device& device, const Case& one, int runs, double seconds);

}  // namespace bench
