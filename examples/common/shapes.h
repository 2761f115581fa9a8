// Simple shapes, added to a mesh. y is up.
#pragma once

#include "mesh.h"

#include <functional>

namespace mesh {

/// A box between two corners.
void add_box(Mesh& mesh, const glift::float3& low, const glift::float3& high, const glift::float3& colour);

/// A rod from one place to another with square ends, of so much thickness; `sides` 3 or more.
void add_rod(Mesh& mesh, const glift::float3& from, const glift::float3& to, float from_radius, float to_radius,
             unsigned sides, const glift::float3& colour);

void add_sphere(Mesh& mesh, const glift::float3& centre, float radius, unsigned rings, const glift::float3& colour);

/// A grid of columns x rows cells; `place` and `colour` of (u, v) in [0, 1]^2. Its front is where u goes to the right
/// and v down.
void add_sheet(Mesh& mesh, unsigned columns, unsigned rows, const std::function<glift::float3(float u, float v)>& place,
               const std::function<glift::float3(float u, float v)>& colour);

}  // namespace mesh
