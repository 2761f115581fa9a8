// Shadows by rays on the CPU (Embree): what the pictures are compared with.
#pragma once

#include "frame.h"

#include <functional>
#include <vector>

namespace rays {

/// Of a pixel: whether light reaches what it shows. `unknown`: the light does not shine on that side of it, or there is
/// nothing.
enum class Light : unsigned char { unknown, reached, shadowed };

struct Reference {
    std::vector<Light> light;
    /// Whether a true edge of a shadow lies within a pixel, so that either answer may be right.
    std::vector<unsigned char> at_edge;  // bytes, since threads write them
};

/// Traces rays to the light from what each pixel of a frame shows. Edges are looked for among the pixels around; where
/// a pixel `is_doubted`, since somebody has another answer, between pixels, too. `is_doubted` is called from several
/// threads.
Reference trace(const Frame& frame, const Lighting& lighting, float bias,
                const std::function<bool(std::size_t pixel, Light)>& is_doubted);

}  // namespace rays
