// Device time of two passes, run alternately.
#pragma once

#include "cases.h"

namespace bench {

struct Measured {
    double generated = 0, handwritten = 0;  ///< median seconds of one pass
    double ratio = 0;                       ///< median of the runs' ratios
    bool agree = false;                     ///< both wrote the same bytes
};

/// `runs` pairs, each pass repeated so often that a run takes about `seconds`; which goes first alternates.
Measured measure(const glift::Device& device, const Case& one, int runs, double seconds);

}  // namespace bench
