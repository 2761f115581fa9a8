#include "frame.h"

#include <glift/host/math.h>

#include <stdexcept>

Method method_of(const std::string& name) {
    if (name == "standard") return Method::standard;
    if (name == "asm") return Method::adaptive;
    if (name == "rmsm") return Method::matched;
    throw std::runtime_error("there is no method '" + name + "'; there are standard, asm and rmsm");
}

Frame::Frame(glift::Device device, const Settings& settings, glift::uint2 size)
    : device_(std::move(device)), settings_(settings), tree_(device_, settings.levels, settings.pages),
      map_(device_, {settings.standard, settings.standard}), picture_(device_, size) {}

void Frame::set_scene(const scenes::Scene& scene) {
    const auto corners = static_cast<std::uint32_t>(scene.mesh.corners.size());
    const auto points = static_cast<std::uint32_t>(scene.mesh.points.size());
    if (!corners_ || corners_->extent() != corners || points_->extent() != points) {
        corners_.emplace(device_, corners);
        points_.emplace(device_, points);
        colours_.emplace(device_, points);
    }
    corners_->write(scene.mesh.corners);
    points_->write(scene.mesh.points);
    colours_->write(scene.mesh.colours);
    scene_ = scene;
}

eye::Viewpoint Frame::view() const {
    const glift::uint2 size = picture_.extent();
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    const glift::float3 to_light = glift::normalize(scene_.light.eye - scene_.light.target);
    return {camera::projection_of(scene_.view, aspect),
            camera::parallel_projection_of(scene_.light, scene_.light_half_size),
            glift::float4(to_light.x, to_light.y, to_light.z, 0), scene_.view.eye, scene_.sky};
}

void Frame::draw(Method method) {
    if (method == Method::standard)
        shadows::with_standard(device_, *corners_, *points_, *colours_, view(), settings_.bias, map_, picture_);
    else
        shadows::with_rmsm(device_, *corners_, *points_, *colours_, view(), settings_.bias, tree_, settings_.pairs,
                           map_, picture_);
}

picture::Picture Frame::picture() const { return {picture_.extent().x, picture_.extent().y, picture_.read(), {}}; }

std::string Frame::status() const {
    const auto status = tree_.status(device_);
    return "pages: " + std::to_string(status.resident) + " of " + std::to_string(status.capacity) + ", " +
           std::to_string(status.refused) + " refused";
}
