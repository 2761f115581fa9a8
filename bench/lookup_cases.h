// The reads of thesis table 6.1, each beside a twin by hand.
#pragma once

#include "cases.h"

namespace bench {

/// `scale` 1 is for lavapipe.
std::vector<Case> make_lookups(const glift::Device& device, std::uint32_t scale);

/// The same case with everything that a call gives as a parameter known when its pipeline is made.
Case specialised(Case one);

}  // namespace bench
