// Methods beside rays: shares of pixels that agree, and pictures of where they do not.
#pragma once

#include "rays.h"

#include <string>

struct Agreement {
    std::size_t pixels = 0;     ///< that the light may reach, off a band of one pixel around true edges of shadows
    std::size_t different = 0;  ///< of these, with another decision than the rays'
    std::size_t in_band = 0;    ///< pixels in that band

    double share() const { return pixels == 0 ? 1 : 1 - static_cast<double>(different) / static_cast<double>(pixels); }
    Agreement& operator+=(const Agreement& other);
};

struct Compared {
    Agreement rmsm, adaptive, standard;
    picture::Picture side_by_side;  ///< RMSM, standard, rays; below them differences of RMSM, ASM, standard to rays
};

/// Draws the frame by all methods, and traces it.
Compared compare(Frame& frame, float bias);
