// Fits the range of a light's depths, from the near to the far plane, to a scene. Depths of a spot or point light are
// finer the farther away its near plane is.
#pragma once

#include "examples/common/scenes/scenes.h"

enum class LightKind { directional, spot, point };

/// The scene's light with other `near` and `far`. For a directional light they enclose all points of the scene, also
/// those behind its eye. For others, `far` is that of the scene's light or, if that is farther away, the farthest
/// point; `near` is as far away as is certain to be before all triangles in sight, but not less than that of the
/// scene's light. `opening`: the tangent of half the angle that the light, or a face of a point light, sees.
camera::Camera fitted_light(const scenes::Scene& scene, LightKind kind, float opening);
