#include "model.h"

#include "examples/common/scenes/scenes.h"
#include "examples/common/shapes.h"

#include <glift/host/math.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace {

using glift::float3;

constexpr float turn = 6.2831853f;

float3 middle_of_knot(float along) {
    const float from = 2 + std::cos(3 * along);
    return {from * std::cos(2 * along), from * std::sin(2 * along), std::sin(3 * along)};
}

/// A tube along a trefoil knot, with grooves, so that a brush does not see all of the surface.
mesh::Mesh knot() {
    mesh::Mesh made;
    const auto place = [](float u, float v) {
        const float along = turn * u, around = turn * v;
        const float3 middle = middle_of_knot(along), towards = middle_of_knot(along + 0.01f) - middle,
                     side = glift::normalize(glift::cross(towards, float3(0, 0, 1))),
                     up = glift::normalize(glift::cross(side, towards));
        const float radius = 0.5f + 0.04f * std::sin(7 * around) + 0.03f * std::sin(60 * along);
        return middle + (side * std::cos(around) + up * std::sin(around)) * radius;
    };
    mesh::add_sheet(made, 900, 90, place, [](float, float) { return float3(1, 1, 1); });
    return made;
}

}  // namespace

mesh::Mesh model_of(const std::string& what) {
    const bool is_file = std::filesystem::exists(what);
    mesh::Mesh mesh = !is_file && what == "knot"                                   ? knot()
                      : !is_file && std::ranges::count(scenes::names(), what) != 0 ? scenes::make(what).mesh
                                                                                   : mesh::read(what);
    mesh::normalise(mesh);
    return mesh;
}

std::vector<float3> bent(const mesh::Mesh& mesh, float angle) {
    if (angle == 0) return mesh.points;
    const mesh::Box box = mesh::bounds_of(mesh);
    const float3 middle = (box.low + box.high) * 0.5f;
    const double by = static_cast<double>(angle);
    std::vector<float3> points;
    for (const float3& p : mesh.points) {
        const double across = static_cast<double>(p.x) - static_cast<double>(middle.x),
                     from = static_cast<double>(p.z) - static_cast<double>(middle.z), at = across * by,
                     half = std::sin(at / 2);
        // The axis is 1 / angle behind the middle, which for small angles is very far: a difference of two distances
        // from it would have no correct digits. Therefore cos(at) - 1 is computed as -2 sin^2(at / 2).
        points.push_back({static_cast<float>(static_cast<double>(middle.x) + std::sin(at) / by + std::sin(at) * from),
                          p.y, static_cast<float>(static_cast<double>(p.z) - 2 * half * half * (1 / by + from))});
    }
    return points;
}
