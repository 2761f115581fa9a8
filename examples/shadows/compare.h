// Methods beside rays: shares of pixels that agree, and pictures of where they do not.
#pragma once

#include "rays.h"

#include <array>
#include <string>

struct Agreement {
    std::size_t pixels = 0;     ///< that the light may reach, off a band of one pixel around true edges of shadows
    std::size_t different = 0;  ///< of these, with another decision than the rays'
    std::size_t in_band = 0;    ///< pixels in that band

    double share() const { return pixels == 0 ? 1 : 1 - static_cast<double>(different) / static_cast<double>(pixels); }
    Agreement& operator+=(const Agreement& other);
};

inline bool is_lit(float share) { return share > 0.5f; }

/// A frame by all methods and by rays.
struct Compared {
    static constexpr std::array methods = {Method::matched, Method::adaptive, Method::standard};
    static constexpr std::array names = {"RMSM", "ASM", "standard"};

    glift::uint2 size;
    std::array<Lighting, 3> lighting;  ///< what `methods` made
    rays::Reference reference;
    std::array<Agreement, 3> agreement;
    std::array<std_page_allocator::PoolStatus, 3> pages;  ///< of the quadtree; the standard map's say nothing

    const Agreement& rmsm() const { return agreement[0]; }
    const Agreement& adaptive() const { return agreement[1]; }
    const Agreement& standard() const { return agreement[2]; }

    picture::Picture by(std::size_t method) const;
    picture::Picture by_rays() const;
    /// Red: another decision than the rays'; blue: that, but in the band.
    picture::Picture differences(std::size_t method) const;
};

/// Draws the frame by all methods, and traces it. Throws std::runtime_error where depths are missing.
Compared compare(Frame& frame, float bias);

/// Pictures of one size in rows of three.
picture::Picture together(const std::vector<picture::Picture>& parts);

/// RMSM, standard, rays; below them differences of RMSM, ASM, standard to rays.
picture::Picture side_by_side(const Compared& compared);
