#include "canvas.h"

#include "paint_file.h"

#include <glift/host/math.h>

#include "examples/common/png.h"

#include <bit>
#include <stdexcept>

namespace {

constexpr std::uint32_t most_of_tip = 4096;

}  // namespace

glift::uint OctreeSize::levels() const { return static_cast<glift::uint>(std::bit_width(resolution / 16)); }

glift::float3 light_of(const camera::Camera& camera) {
    const glift::float3 arm = camera.eye - camera.target;
    const glift::float3 right = glift::normalize(glift::cross(camera.up, arm));
    return glift::normalize(glift::normalize(arm) + right * -0.5f + camera.up * 0.7f);
}

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

const paint::Tip& Canvas::tip_of(const std::string& picture) {
    if (const auto found = tips_.find(picture); found != tips_.end()) return found->second;
    png::Picture read{1, 1, {1}};
    if (!picture.empty()) read = png::read(picture);
    if (!picture.empty() && (read.width < 2 || read.width > most_of_tip || read.height > most_of_tip))
        throw std::runtime_error(picture + ": the picture of a brush has to be 2 to " + std::to_string(most_of_tip) +
                                 " pixels wide, and no higher than that");
    paint::Tip tip(device_, {read.width, read.height});
    tip.write(read.values);
    return tips_.emplace(picture, std::move(tip)).first->second;
}

void Canvas::begin(const strokes::Stroke& stroke) {
    tip_ = tip_of(stroke.brush.picture);
    if (surface_.extent() != stroke.size) {
        surface_ = surface::Surface(device_, stroke.size);
        normals_ = surface::Normals(device_, stroke.size);
    }
    view_ = strokes::viewpoint_of(stroke.camera, stroke.size);
    surface::look(device_, model_.corners(), model_.rest(), model_.rest(), view_, surface_, normals_);
    journal_.clear(device_);
}

void Canvas::dab(const paint::Brush& brush) {
    paint::paint(device_, octree_, journal_, surface_, normals_, view_, brush, tip_, size_.ground);
}

glift::uint Canvas::end() {
    paint::finish(device_, octree_, journal_);
    history_.add(device_, octree_, journal_);
    return journal_.lost_pages(device_);
}

glift::uint Canvas::paint(const strokes::Stroke& stroke) {
    begin(stroke);
    for (const paint::Brush& brush : strokes::dabs_of(stroke)) dab(brush);
    return end();
}

npy::Array Canvas::samples(glift::uint side) const {
    const painted::Dense dense(device_, {side, side, side});
    painted::as_field(device_, octree_, dense);
    npy::Array array{{4, side, side, side}, {}};
    for (const glift::float4& c : dense.read()) array.values.insert(array.values.end(), {c.x, c.y, c.z, c.w});
    return array;
}

Canvas::Bytes Canvas::bytes() const {
    const auto texels = octree_.frames().texels().data().extent();
    return {std::uint64_t{4} * texels[0] * texels[1] * texels[2], std::uint64_t{4} * octree_.best().extent()};
}

void Canvas::save(const std::string& path) { paint_file::save(path, device_, octree_, size_.ground); }

void Canvas::load(const std::string& path) {
    size_.ground = paint_file::load(path, device_, octree_).ground;
    history_.clear();
}

void Canvas::render(const camera::Camera& camera, painted::Layers layers, const painted::Film& film) {
    painted::render(device_, model_.corners(), model_.rest(), model_.posed(),
                    strokes::viewpoint_of(camera, film.extent()), light_of(camera), sky, octree_, layers, film);
}

picture::Picture Canvas::render(const camera::Camera& camera, glift::uint2 size, painted::Layers layers) {
    painted::Film film(device_, size);
    render(camera, layers, film);
    return {size.x, size.y, film.read(), {}};
}

void Canvas::render(const camera::Camera& camera, painted::Layers layers, const shown::Shown& to) {
    painted::Film film(device_, to.extent());
    render(camera, layers, film);
    painted::to_screen(device_, film, to);
}
