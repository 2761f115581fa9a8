// Shadows by rays on the CPU (Embree): what the pictures are compared with.
#pragma once

#include "frame.h"

#include <functional>
#include <vector>

namespace rays {

/// Whether light reaches the surface that a pixel shows. `unknown`: its side is turned away from the light, it is
/// outside of what a spot light shines on, it is nearer than the near plane of a spot or point light, or the pixel
/// shows no surface.
enum class Light : unsigned char { unknown, reached, shadowed };

struct Reference {
    std::vector<Light> light;
    /// Whether trace() found an edge of a shadow beside the pixel, so that either answer may be right.
    std::vector<unsigned char> at_edge;  // not vector<bool>, whose elements threads cannot write independently
};

/// Traces rays to the light from what each pixel of a frame shows. They begin a little away from the surface: by `bias`
/// times the light's range, far - near. A pixel is at an edge if one of the eight pixels around it has the other
/// answer. Where `is_doubted` says that some method decides otherwise than the ray, more rays look for an edge between
/// pixels. `is_doubted` is called from several threads.
Reference trace(const Frame& frame, const Lighting& lighting, float bias,
                const std::function<bool(std::size_t pixel, Light)>& is_doubted);

}  // namespace rays
