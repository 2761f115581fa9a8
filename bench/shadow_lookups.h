// How long lookups of a plain shadow map take, as examples/shadows does them and by the hardware's comparison.
#pragma once

#include "examples/shadows/frame.h"

#include <vector>

namespace bench {

/// Mean seconds of the kernel that looks up all pixels of a frame, timed as PassTimer does.
struct LookupTimes {
    double gather = 0;                             ///< four texels by a gather, compared and weighted in the shader
    double nearest = 0;                            ///< one texel, compared in the shader
    double compare = 0;                            ///< the hardware compares and weighs four texels
    double lit_by_gather = 0, lit_by_compare = 0;  ///< mean share of light over pixels: nearly equal
};

/// Times lookups of a standard map of `settings.standard` texels a side, for the pixels of frames of these scenes.
/// Throws glift::Error for the host device, which has no passes to time.
LookupTimes lookup_times(const glift::Device& device, const Settings& settings,
                         const std::vector<scenes::Scene>& scenes, glift::uint2 size);

}  // namespace bench
