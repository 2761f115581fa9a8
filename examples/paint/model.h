// The meshes that can be painted on, and how they are bent.
#pragma once

#include "examples/common/mesh.h"

#include <string>
#include <vector>

/// The mesh in the file of this name, of a format that mesh::read reads; if there is no such file, the generated knot
/// ("knot") or the generated scene of this name. It is scaled into [0, 1]^3. Throws std::runtime_error, which says what
/// is wrong.
mesh::Mesh model_of(const std::string& what);

/// The mesh's points, bent around an upright axis behind its middle: by `angle` radians for each unit of length along x
/// (models are at most one unit long). Small angles are as exact as others.
std::vector<glift::float3> bent(const mesh::Mesh& mesh, float angle);
