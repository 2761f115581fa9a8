#include "input.h"

#include "examples/common/render.h"

#include <glift/host/math.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace input {

namespace {

/// A mesh from a file on a table, seen from before it.
scenes::Scene scene_of_file(const std::string& path) {
    scenes::Scene scene;
    scene.mesh = mesh::read(path);
    mesh::normalise(scene.mesh);
    const mesh::Box box = mesh::bounds_of(scene.mesh);
    const glift::float3 middle = (box.low + box.high) * 0.5f;
    scene.view = {middle + glift::float3(0.7f, 0.35f, 1.5f), middle, glift::float3(0, 1, 0), 0.6f, 0.05f, 20};
    scene.light.eye = middle + glift::float3(2, 3, 2);
    scene.light.target = middle;
    return scene;
}

/// Seen through the camera: its angle is that of the film behind the lens.
scenes::Scene scene_for(const std::string& name, float time, const Camera& camera, float aspect) {
    scenes::Scene scene = name.find('.') == std::string::npos ? scenes::make(name, time) : scene_of_file(name);
    scene.view.height_angle = 2 * std::atan(0.5f * camera.film_width / aspect / camera.image_distance());
    return scene;
}

/// What is nearer than a distance, and nothing elsewhere.
picture::Picture drawn_before(const scenes::Scene& scene, const picture::Picture& all, float distance) {
    picture::Picture layer = render::drawn(scene, all.width, all.height, {0, distance});
    for (std::size_t i = 0; i < layer.pixels.size(); ++i) {
        layer.pixels[i] = layer.pixels[i] * layer.pixels[i].w;  // no sky in it
        layer.depth[i] = std::min(layer.depth[i], distance);
    }
    return layer;
}

/// What is farther than a distance. Where something nearer was cut away and nothing is behind it, alpha 0: a hole,
/// which holds what was cut away.
picture::Picture drawn_behind(const scenes::Scene& scene, const picture::Picture& all, float distance) {
    const picture::Picture layer = render::drawn(scene, all.width, all.height, {distance});
    picture::Picture made = render::before_sky(layer);
    for (std::size_t i = 0; i < layer.pixels.size(); ++i)
        if (layer.pixels[i].w == 0 && all.depth[i] < distance)
            made.pixels[i] = glift::float4(all.pixels[i].x, all.pixels[i].y, all.pixels[i].z, 0);
    return made;
}

float aspect_of(std::uint32_t width, std::uint32_t height) {
    return static_cast<float>(width) / static_cast<float>(height);
}

}  // namespace

void check(const Camera& camera) {
    const bool is_lens = camera.focal > 0 && camera.f_stop > 0 && camera.film_width > 0 && std::isfinite(camera.focus);
    if (!is_lens) throw std::runtime_error("focal length, f-stop and film width are numbers above 0");
    if (camera.focus <= camera.focal)
        throw std::runtime_error("the focus distance, " + std::to_string(camera.focus) +
                                 " m, has to be larger than the focal length, " + std::to_string(camera.focal) + " m");
}

Layers of_scene(const std::string& name, float time, std::uint32_t width, std::uint32_t height, const Camera& camera,
                const Cuts& cuts, unsigned layers) {
    const scenes::Scene scene = scene_for(name, time, camera, aspect_of(width, height));
    Layers made{render::before_sky(render::drawn(scene, width, height)), {}, {}, {}};
    if (layers < 3) return made;
    const float front = cuts.front_distance(camera), back = cuts.back_distance(camera);
    made.front = drawn_before(scene, made.all, front);
    made.behind = drawn_behind(scene, made.all, front);
    made.back = drawn_behind(scene, made.all, back);
    return made;
}

Layers of_files(const std::string& colour, const std::string& depth, const std::string& front) {
    Layers read{picture::read(colour), {}, {}, {}};
    if (!depth.empty()) {
        const picture::Picture distances = picture::read(depth);
        if (distances.width != read.all.width || distances.height != read.all.height)
            throw std::runtime_error(depth + ": is not as large as " + colour);
        read.all.depth = distances.depth;
        if (read.all.depth.empty())  // a picture of distances alone
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

picture::Picture reference(const std::string& name, float time, std::uint32_t width, std::uint32_t height,
                           const Camera& camera, unsigned samples) {
    const scenes::Scene scene = scene_for(name, time, camera, aspect_of(width, height));
    return render::through_lens(scene, width, height, camera.aperture(), camera.focus, samples);
}

}  // namespace input
