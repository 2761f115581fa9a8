// What there is to paint on.
#pragma once

#include "examples/common/mesh.h"

#include <string>

/// Within [0, 1]^3: a file that assimp reads, or where there is none the knot or a scene of that name. Throws
/// std::runtime_error, which says what is wrong.
mesh::Mesh model_of(const std::string& what);
