// The meshes that can be painted on.
#pragma once

#include "examples/common/mesh.h"

#include <string>

/// The mesh in the file of this name, of a format that mesh::read reads; if there is no such file, the generated knot
/// ("knot") or the generated scene of this name. It is scaled into [0, 1]^3. Throws std::runtime_error, which says what
/// is wrong.
mesh::Mesh model_of(const std::string& what);
