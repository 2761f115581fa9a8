// Triangle meshes, read from files or made of shapes (shapes.h).
#pragma once

#include <glift/vector.h>

#include <cstdint>
#include <string>
#include <vector>

namespace mesh {

/// An indexed mesh: points with a colour each (linear, 0 to 1), and for each triangle three indices of points, in
/// counter-clockwise order as seen from outside.
struct Mesh {
    std::vector<glift::float3> points, colours;
    std::vector<std::uint32_t> corners;

    std::size_t triangles() const { return corners.size() / 3; }
    bool operator==(const Mesh&) const = default;
};

struct Box {
    glift::float3 low, high;
};

/// Reads a file of any format that assimp knows (PLY, OBJ, glTF, FBX, …). Points of one mesh of the file that
/// are equal in all that the file says of them are joined, and some that differ by less than 1e-5; then the triangles
/// of all its meshes become one mesh. Points without a colour are light grey. A file whose name ends in .gz
/// (`dragon.ply.gz`) is unpacked first. Throws std::runtime_error, which names the file and what is wrong, also where a
/// triangle has a corner that is not finite.
Mesh read(const std::string& path);

/// The bounding box of the triangles; points that no triangle has do not count. Of an empty mesh it is from 0 to 0.
Box bounds_of(const Mesh& mesh);

/// Moves and uniformly scales the mesh so that its bounding box begins at 0, and its longest side, if not 0, is 1.
void normalise(Mesh& mesh);

/// Adds the triangles of another mesh.
void append(Mesh& mesh, const Mesh& other);

}  // namespace mesh
