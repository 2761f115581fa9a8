#include "canvas.h"

#include "mips.glift.hpp"
#include "paint_file.h"

#include <glift/host/math.h>

#include <bit>

glift::uint OctreeSize::levels() const { return static_cast<glift::uint>(std::bit_width(resolution / 16)); }

Model::Model(const glift::Device& device, const mesh::Mesh& mesh)
    : corners_(device, static_cast<glift::uint>(mesh.corners.size())),
      rest_(device, static_cast<glift::uint>(mesh.points.size())),
      posed_(device, static_cast<glift::uint>(mesh.points.size())) {
    corners_.write(mesh.corners);
    rest_.write(mesh.points);
    posed_.write(mesh.points);
}

void Model::pose(const std::vector<glift::float3>& points) { posed_.write(points); }

Canvas::Canvas(glift::Device device, const mesh::Mesh& mesh, const OctreeSize& size)
    : device_(std::move(device)), size_(size), model_(device_, mesh), octree_(device_, size.levels(), size.pages),
      journal_(device_, size.levels(), size.pages), history_(size.history), surface_(device_, {1, 1}),
      normals_(device_, {1, 1}) {
    paint::clear(device_, octree_, size_.ground);
}

void Canvas::look(const surface::Viewpoint& view, glift::uint2 size) {
    if (surface_.extent() != size) {
        surface_ = surface::Surface(device_, size);
        normals_ = surface::Normals(device_, size);
    }
    surface::look(device_, model_.corners(), model_.rest(), model_.posed(), view, surface_, normals_);
}

glift::uint Canvas::paint(const strokes::Stroke& stroke) {
    journal_.clear(device_);
    const surface::Viewpoint view = strokes::viewpoint_of(stroke.camera, stroke.size);
    look(view, stroke.size);
    for (const paint::Brush& dab : strokes::dabs_of(stroke))
        paint::paint(device_, octree_, journal_, surface_, normals_, view, dab, size_.ground);
    mips::finish(device_, octree_, journal_);
    history_.add(device_, octree_, journal_);
    return journal_.lost_pages(device_);
}

void Canvas::save(const std::string& path) { paint_file::save(path, device_, octree_, size_.ground); }

void Canvas::load(const std::string& path) {
    size_.ground = paint_file::load(path, device_, octree_).ground;
    history_.clear();
}

picture::Picture Canvas::render(const camera::Camera& camera, glift::uint2 size, painted::Layers layers) {
    painted::Film film(device_, size);
    const glift::float3 arm = camera.eye - camera.target;
    const glift::float3 right = glift::normalize(glift::cross(camera.up, arm));
    const glift::float3 to_light = glift::normalize(glift::normalize(arm) + right * -0.5f + camera.up * 0.7f);
    painted::render(device_, model_.corners(), model_.rest(), model_.posed(), strokes::viewpoint_of(camera, size),
                    to_light, {0.09f, 0.10f, 0.12f}, octree_, layers, film);
    return {size.x, size.y, film.read(), {}};
}
