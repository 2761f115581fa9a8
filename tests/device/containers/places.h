// Random addresses in planes, for property tests.
#pragma once

#include "property.h"

#include <vector>

namespace property {

/// One to `most` random addresses: most of them in a square of at most `widest` addresses along each axis that begins
/// anywhere in the extent, one in 50 far outside the extent.
inline std::vector<glift::uint2> places_near(Round& round, glift::uint2 extent, std::uint32_t most,
                                             std::uint32_t widest) {
    std::vector<glift::uint2> made(1 + round.below(most));
    const glift::uint2 first{round.below(extent.x), round.below(extent.y)};
    const std::uint32_t spread = 1 + round.below(widest);
    for (glift::uint2& place : made) {
        place = {first.x + round.below(spread), first.y + round.below(spread)};
        if (round.chance(50)) place = {0u - 1 - round.below(9), round.below(20)};
    }
    return made;
}

}  // namespace property
