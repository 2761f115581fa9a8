// Jointed figures, posed by the angles of their joints.
#pragma once

#include <glift/vector.h>

#include <cmath>

namespace scenes {

/// Where a figure stands and in which direction it looks. Joints turn in the plane of `forward` and the vertical.
struct Stance {
    glift::float3 place, forward;

    glift::float3 right() const { return glift::float3(-forward.z, 0, forward.x); }
    /// The end of a limb of this length that hangs from `joint` and is swung forwards by an angle.
    glift::float3 swung(const glift::float3& joint, float length, float angle) const {
        return joint + forward * (length * std::sin(angle)) - glift::float3(0, length * std::cos(angle), 0);
    }
};

inline Stance facing(const glift::float3& place, float angle) {
    return {place, glift::float3(std::sin(angle), 0, std::cos(angle))};
}

}  // namespace scenes
