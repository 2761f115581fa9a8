// Triangle meshes: from files, and put together from shapes.
#pragma once

#include <glift/vector.h>

#include <cstdint>
#include <string>
#include <vector>

namespace mesh {

/// Points with a colour each (linear, 0 to 1), and three corners a triangle: numbers of points, counter-clockwise as
/// seen from outside.
struct Mesh {
    std::vector<glift::float3> points, colours;
    std::vector<std::uint32_t> corners;

    std::size_t triangles() const { return corners.size() / 3; }
};

struct Box {
    glift::float3 low, high;
};

/// Reads any format that assimp knows (PLY, OBJ, glTF, FBX, …), all meshes of the file as one, points that are equal
/// joined. Points without a colour are light grey. A PLY file may be packed by gzip. Throws std::runtime_error, which
/// names the file and what is wrong.
Mesh read(const std::string& path);

/// Of an empty mesh: from 0 to 0.
Box bounds_of(const Mesh& mesh);

/// Moved and scaled alike along all axes, so that its bounds lie in [0, 1] and touch it along the longest one.
void normalise(Mesh& mesh);

/// Adds the triangles of another.
void append(Mesh& mesh, const Mesh& other);

}  // namespace mesh
