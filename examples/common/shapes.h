// Functions that add simple shapes to a mesh. y is up.
#pragma once

#include "mesh.h"

#include <functional>

namespace mesh {

/// Adds a box between two opposite corners.
void add_box(Mesh& mesh, const glift::float3& low, const glift::float3& high, const glift::float3& colour);

/// Adds a rod between two points, with flat ends and a radius for each; its cross-section has `sides` (at least 3)
/// sides. Adds nothing if the points are equal.
void add_rod(Mesh& mesh, const glift::float3& from, const glift::float3& to, float from_radius, float to_radius,
             unsigned sides, const glift::float3& colour);

void add_sphere(Mesh& mesh, const glift::float3& centre, float radius, unsigned rings, const glift::float3& colour);

/// Adds a surface of columns x rows quads; `place` and `colour` give points and colours for (u, v) in [0, 1]^2. Seen
/// from the front, u goes to the right and v down.
void add_sheet(Mesh& mesh, unsigned columns, unsigned rows, const std::function<glift::float3(float u, float v)>& place,
               const std::function<glift::float3(float u, float v)>& colour);

}  // namespace mesh
