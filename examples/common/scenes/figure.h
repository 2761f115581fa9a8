// Jointed figures: limbs that hang on each other by angles.
#pragma once

#include <glift/vector.h>

#include <cmath>

namespace scenes {

/// A place and a direction in which a figure looks: joints turn in the plane of `forward` and up.
struct Stance {
    glift::float3 place, forward;

    glift::float3 right() const { return glift::float3(-forward.z, 0, forward.x); }
    /// Down by `length`, swung forwards by an angle.
    glift::float3 swung(const glift::float3& joint, float length, float angle) const {
        return joint + forward * (length * std::sin(angle)) - glift::float3(0, length * std::cos(angle), 0);
    }
};

inline Stance facing(const glift::float3& place, float angle) {
    return {place, glift::float3(std::sin(angle), 0, std::cos(angle))};
}

}  // namespace scenes
