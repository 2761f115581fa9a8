#include "mesh.h"

#include <glift/host/math.h>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace mesh {

namespace {

using glift::float3;

constexpr float grey = 0.7f;

/// Reads a file, decompressing it if it is compressed by gzip.
std::string unpacked(const std::string& path) {
    std::unique_ptr<gzFile_s, decltype(&gzclose)> file(gzopen(path.c_str(), "rb"), &gzclose);
    if (!file) throw std::runtime_error(path + ": cannot be opened");
    std::string bytes, part(1 << 20, '\0');
    int count = 0;
    while ((count = gzread(file.get(), part.data(), static_cast<unsigned>(part.size()))) > 0)
        bytes.append(part, 0, static_cast<std::size_t>(count));
    if (count < 0) throw std::runtime_error(path + ": is damaged: gzip cannot unpack it");
    // Only gzclose reports that the file ended in the middle of the compressed data.
    if (gzclose(file.release()) != Z_OK) throw std::runtime_error(path + ": is truncated: gzip finds no end");
    return bytes;
}

void add(Mesh& mesh, const aiMesh& part) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
        const aiVector3D& p = part.mVertices[i];
        mesh.points.emplace_back(p.x, p.y, p.z);
        const aiColor4D* colours = part.mColors[0];
        mesh.colours.push_back(colours ? float3(colours[i].r, colours[i].g, colours[i].b) : float3(grey, grey, grey));
    }
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
        const aiFace& face = part.mFaces[i];
        if (face.mNumIndices == 3)
            for (unsigned corner = 0; corner < 3; ++corner) mesh.corners.push_back(first + face.mIndices[corner]);
    }
}

void check(const std::string& path, const Mesh& mesh) {
    if (mesh.corners.empty()) throw std::runtime_error(path + ": has no triangles");
    for (const std::uint32_t corner : mesh.corners) {
        const float3& p = mesh.points[corner];
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
            throw std::runtime_error(path +
                                     ": has a triangle with a corner that is no place: a coordinate is not finite");
    }
    const Box box = bounds_of(mesh);
    if (!std::isfinite(glift::length(box.high - box.low)))
        throw std::runtime_error(path + ": is too large for 32-bit numbers");
}

}  // namespace

Mesh read(const std::string& path) {
    Assimp::Importer importer;
    // Damaged files may have faces with corners that are not in the file: the other steps would crash.
    constexpr unsigned steps = aiProcess_ValidateDataStructure | aiProcess_Triangulate |
                               aiProcess_JoinIdenticalVertices | aiProcess_PreTransformVertices | aiProcess_SortByPType;
    const std::filesystem::path name(path);
    const aiScene* scene = nullptr;
    if (name.extension() == ".gz") {
        const std::string bytes = unpacked(path);
        scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), steps, name.stem().extension().c_str());
    } else {
        scene = importer.ReadFile(path, steps);
    }
    if (!scene) throw std::runtime_error(path + ": cannot be read as a mesh: " + importer.GetErrorString());
    Mesh mesh;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) add(mesh, *scene->mMeshes[i]);
    check(path, mesh);
    return mesh;
}

Box bounds_of(const Mesh& mesh) {
    if (mesh.corners.empty()) return {float3(0, 0, 0), float3(0, 0, 0)};
    Box box{mesh.points[mesh.corners[0]], mesh.points[mesh.corners[0]]};
    for (const std::uint32_t corner : mesh.corners)
        box = {glift::min(box.low, mesh.points[corner]), glift::max(box.high, mesh.points[corner])};
    return box;
}

void normalise(Mesh& mesh) {
    const Box box = bounds_of(mesh);
    const float3 size = box.high - box.low;
    const float longest = std::max({size.x, size.y, size.z});
    const float scale = longest > 0 ? 1 / longest : 1;
    for (float3& p : mesh.points) p = (p - box.low) * scale;
}

void append(Mesh& mesh, const Mesh& other) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
    mesh.colours.insert(mesh.colours.end(), other.colours.begin(), other.colours.end());
    for (const std::uint32_t corner : other.corners) mesh.corners.push_back(first + corner);
}

}  // namespace mesh
