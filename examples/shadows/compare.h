// Compares shadows by all methods with shadows by rays: shares of pixels that agree, and pictures of where they do not.
#pragma once

#include "rays.h"

#include <array>
#include <optional>
#include <string>

struct Agreement {
    std::size_t pixels = 0;     ///< pixels that the light may reach, outside a band of a pixel around true shadow edges
    std::size_t different = 0;  ///< those of `pixels` that are lit where rays say shadowed, or the reverse
    std::size_t in_band = 0;    ///< pixels that the light may reach in that band

    /// The share of `pixels` that agree; absent where there are none.
    std::optional<double> share() const {
        if (pixels == 0) return {};
        return 1 - static_cast<double>(different) / static_cast<double>(pixels);
    }
    Agreement& operator+=(const Agreement& other);
};

inline bool is_lit(float share) { return share > 0.5f; }

/// A frame's shadows by all methods and by rays. Arrays have an element for each method, in the order of `methods`.
struct Compared {
    static constexpr std::array methods = {Method::matched, Method::adaptive, Method::standard};
    static constexpr std::array names = {"RMSM", "ASM", "standard"};

    glift::uint2 size;
    std::array<Lighting, 3> lighting;
    rays::Reference reference;
    std::array<Agreement, 3> agreement;
    std::array<shadows::Status, 3> counts;  ///< of the quadtree, which the standard map does not use

    const Agreement& rmsm() const { return agreement[0]; }
    const Agreement& adaptive() const { return agreement[1]; }
    const Agreement& standard() const { return agreement[2]; }

    picture::Picture by(std::size_t method) const;
    picture::Picture by_rays() const;
    /// The frame in grey; red where the method decides otherwise than the rays, blue if that is in the band.
    picture::Picture differences(std::size_t method) const;
};

/// Draws the frame by all methods, and traces rays for it. Throws std::runtime_error if depths are missing
/// (Frame::status).
Compared compare(Frame& frame, float bias);

/// One picture of several that have the same size, in rows of three.
picture::Picture together(const std::vector<picture::Picture>& parts);

/// The pictures by RMSM, by standard and by rays; below them differences() of RMSM, ASM and standard.
picture::Picture side_by_side(const Compared& compared);
