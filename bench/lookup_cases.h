// The reads of table 6.1 of Lefohn's thesis (2006), each as a generated kernel and as a hand-written one.
#pragma once

#include "cases.h"

namespace bench {

/// All cases of bench_lookups. The work grows with `scale`; 1 suits lavapipe.
std::vector<Case> make_lookups(const glift::Device& device, std::uint32_t scale);

/// The same case with all parameters of its calls fixed as constants when its pipeline is made.
Case specialised(Case one);

}  // namespace bench
