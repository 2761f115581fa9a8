#include "input.h"

#include "examples/common/shapes.h"

#include <glift/host/math.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace input {

namespace {

using glift::float3;

/// Adds a chequered table at y = 0: 64 x 64 tiles of a quarter of a metre, from behind the camera (z = 3) to z = -13.
void add_table(mesh::Mesh& mesh) {
    constexpr int columns = 64, rows = 64;
    constexpr float side = 0.25f;
    for (int column = 0; column < columns; ++column)
        for (int row = 0; row < rows; ++row) {
            const float x = side * static_cast<float>(column - columns / 2), z = side * static_cast<float>(row - 52);
            const auto place = [&](float u, float v) { return float3(x + side * u, 0, z + side * v); };
            const bool is_dark = (column + row) % 2 == 1;
            const auto colour = [&](float, float) {
                return is_dark ? float3(0.1f, 0.13f, 0.18f) : float3(0.55f, 0.5f, 0.42f);
            };
            mesh::add_sheet(mesh, 1, 1, place, colour);
        }
}

/// Adds a row of balls, from the left front to the right back.
void add_balls(mesh::Mesh& mesh, const float3& middle) {
    const float3 colours[] = {float3(0.7f, 0.1f, 0.08f), float3(0.9f, 0.6f, 0.1f), float3(0.1f, 0.25f, 0.6f)};
    for (const int i : {-2, -1, 1, 2, 3, 4, 5, 6}) {  // the mesh stands at 0
        const auto at = static_cast<float>(i);
        mesh::add_sphere(mesh, float3(middle.x - 0.15f + 0.3f * at, 0.09f, middle.z + 0.1f - 0.62f * at), 0.09f, 24,
                         colours[static_cast<unsigned>(i + 3) % 3]);
    }
}

/// A mesh from a file, a metre long, on a table with balls.
scenes::Scene scene_of_file(const std::string& path) {
    scenes::Scene scene;
    scene.mesh = mesh::read(path);
    mesh::normalise(scene.mesh);
    const mesh::Box box = mesh::bounds_of(scene.mesh);
    const float3 middle = (box.low + box.high) * 0.5f;
    add_table(scene.mesh);
    add_balls(scene.mesh, middle);
    scene.view = {middle + float3(0.5f, 0.5f, 2.2f), middle, float3(0, 1, 0), 0.6f, 0.05f, 40};
    scene.light.eye = middle + float3(2, 3, 2);
    scene.light.target = middle;
    return scene;
}

}  // namespace

void check(const Camera& camera) {
    const bool is_lens = camera.focal > 0 && camera.f_stop > 0 && camera.film_width > 0 && std::isfinite(camera.focus);
    if (!is_lens) throw std::runtime_error("focal length, f-stop and film width are numbers above 0");
    if (camera.focus <= camera.focal)
        throw std::runtime_error("the focus distance, " + std::to_string(camera.focus) +
                                 " m, has to be larger than the focal length, " + std::to_string(camera.focal) + " m");
}

scenes::Scene scene(const std::string& name, float time) {
    return name.find('.') == std::string::npos ? scenes::make(name, time) : scene_of_file(name);
}

camera::Camera seen_through(const camera::Camera& view, const Camera& camera, float aspect) {
    camera::Camera seen = view;
    seen.height_angle = 2 * std::atan(0.5f * camera.film_width / aspect / camera.image_distance());
    return seen;
}

Pictures pictures(const std::string& colour, const std::string& depth, const std::string& front) {
    Pictures read{picture::read(colour), {}};
    if (!depth.empty()) {
        const picture::Picture distances = picture::read(depth);
        if (distances.width != read.all.width || distances.height != read.all.height)
            throw std::runtime_error(depth + ": is not as large as " + colour);
        read.all.depth = distances.depth;
        if (read.all.depth.empty())  // no channel Z: distances are in the red channel
            for (const glift::float4& pixel : distances.pixels) read.all.depth.push_back(pixel.x);
    }
    if (read.all.depth.empty())
        throw std::runtime_error(colour + ": has no distances (channel Z); name a picture of them with --depth");
    if (front.empty()) return read;
    read.front = picture::read(front);
    if (read.front->depth.empty()) throw std::runtime_error(front + ": has no distances (channel Z)");
    if (read.front->width != read.all.width || read.front->height != read.all.height)
        throw std::runtime_error(front + ": is not as large as " + colour);
    return read;
}

}  // namespace input
