// The range of distances that a light's depths tell apart, made to hold a scene and little more: depths of a light with
// a place are finer the farther away its near plane is.
#pragma once

#include "examples/common/scenes/scenes.h"

enum class LightKind { directional, spot, point };

/// The scene's light with another range. Of a parallel one it is from the nearest to the farthest point, on whichever
/// side of its eye. Of others its end is that of the scene's light or, if that is farther, the farthest point; it
/// begins as far away as is certain to be before all triangles in sight, at the scene's near plane at least. `opening`:
/// the tangent of half the angle that the light, or a face of a point light, sees.
camera::Camera fitted_light(const scenes::Scene& scene, LightKind kind, float opening);
