#include "subject.h"

#include <glift/host/math.h>

#include <optional>
#include <stdexcept>

using picture::Picture;

namespace {

Picture read(const dof::Picture& made) { return {made.extent().x, made.extent().y, made.read(), {}}; }

/// A mesh, which is drawn for each photograph.
class Scene : public Subject {
public:
    Scene(const Settings& settings, glift::Device device, const scenes::Scene& scene, glift::uint2 size)
        : Subject(settings, std::move(device), size),
          corners_(device_, static_cast<std::uint32_t>(scene.mesh.corners.size())),
          points_(device_, static_cast<std::uint32_t>(scene.mesh.points.size())),
          colours_(device_, static_cast<std::uint32_t>(scene.mesh.points.size())), pinhole_(device_, size),
          view_(scene.view), to_light_(glift::normalize(scene.light.eye - scene.light.target)), sky_(scene.sky) {
        corners_.write(scene.mesh.corners);
        points_.write(scene.mesh.points);
        colours_.write(scene.mesh.colours);
    }

    void photograph() override {
        photograph::photograph(device_, corners_, points_, colours_, viewpoint(), lens(), settings_.layers,
                               settings_.cuts, settings_.holes(), pinhole_.colour, pinhole_.distances, result_);
    }
    const Images& pinhole() const override { return pinhole_; }
    Picture reference(unsigned places) override {
        const dof::Picture mean(device_, result_.extent());
        photograph::many_pinholes(device_, corners_, points_, colours_, viewpoint(), lens(), places, mean);
        return read(mean);
    }
    bool resize(glift::uint2 size) override {
        if (size == result_.extent()) return true;
        result_ = dof::Picture(device_, size);
        pinhole_ = Images(device_, size);
        return true;
    }
    unsigned most_layers() const override { return 3; }

private:
    photograph::Viewpoint viewpoint() const {
        const glift::uint2 size = result_.extent();
        const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
        const camera::Camera view = input::seen_through(view_, settings_.camera, aspect);
        return {camera::projection_of(view, aspect), view.eye, to_light_, sky_, view.far};
    }

    photograph::Corners corners_;
    photograph::Points points_, colours_;
    Images pinhole_;
    camera::Camera view_;
    glift::float3 to_light_, sky_;
};

/// Pictures from files.
class Files : public Subject {
public:
    Files(const Settings& settings, glift::Device device, const input::Pictures& pictures)
        : Subject(settings, std::move(device), {pictures.all.width, pictures.all.height}), all_(device_, pictures.all),
          without_front_(device_, result_.extent()) {
        if (pictures.front) front_.emplace(device_, *pictures.front);
        else if (settings.layers == 3) throw std::runtime_error("a third layer of a picture needs --foreground");
    }

    void photograph() override {
        const dof::Picture& to = front_ ? without_front_ : result_;
        if (settings_.layers == 1) dof::one_layer(device_, all_.colour, all_.distances, lens(), to);
        else dof::two_layers(device_, all_.colour, all_.distances, lens(), settings_.cuts.back, settings_.holes(), to);
        if (front_)
            dof::foreground(device_, front_->colour, front_->distances, lens(), settings_.cuts.front, to, result_);
    }
    const Images& pinhole() const override { return all_; }
    Picture reference(unsigned) override {
        throw std::runtime_error("--reference needs a scene: many pinholes are drawn of it");
    }
    bool resize(glift::uint2) override { return false; }
    unsigned most_layers() const override { return front_ ? 3 : 2; }

private:
    Images all_;
    std::optional<Images> front_;
    dof::Picture without_front_;
};

}  // namespace

Images::Images(const glift::Device& device, const Picture& picture)
    : Images(device, glift::uint2(picture.width, picture.height)) {
    colour.write(picture.pixels);
    distances.write(picture.depth);
}

dof::Lens Subject::lens() const {
    const input::Camera& camera = settings_.camera;
    return {camera.focal, camera.aperture(), camera.focus, static_cast<float>(result_.extent().x) / camera.film_width};
}

Picture Subject::result() const { return read(result_); }

Picture Subject::circles() const {
    photograph::circle_picture(device_, pinhole().distances, lens(), result_);
    return result();
}

Picture Subject::layers() const {
    photograph::layer_picture(device_, pinhole().colour, pinhole().distances, lens(), settings_.cuts, result_);
    return result();
}

std::unique_ptr<Subject> scene_subject(const Settings& settings, const glift::Device& device,
                                       const scenes::Scene& scene, glift::uint2 size) {
    return std::make_unique<Scene>(settings, device, scene, size);
}

std::unique_ptr<Subject> picture_subject(const Settings& settings, const glift::Device& device,
                                         const input::Pictures& pictures) {
    return std::make_unique<Files>(settings, device, pictures);
}
