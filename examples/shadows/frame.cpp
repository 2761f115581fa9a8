#include "frame.h"

#include <glift/host/math.h>

#include <stdexcept>

namespace {

template <class Choice>
Choice choice_of(const std::string& name, std::initializer_list<std::pair<const char*, Choice>> all) {
    std::string known;
    for (const auto& [word, choice] : all) {
        if (name == word) return choice;
        known += (known.empty() ? "" : ", ") + std::string(word);
    }
    throw std::runtime_error("there is no '" + name + "'; there are " + known);
}

}  // namespace

Method method_of(const std::string& name) {
    return choice_of<Method>(name,
                             {{"standard", Method::standard}, {"asm", Method::adaptive}, {"rmsm", Method::matched}});
}

View view_of(const std::string& name) {
    return choice_of<View>(name, {{"picture", View::picture},
                                  {"levels", View::levels},
                                  {"borders", View::borders},
                                  {"map", View::map},
                                  {"pool", View::pool}});
}

Frame::Frame(glift::Device device, const Settings& settings, glift::uint2 size)
    : device_(std::move(device)), settings_(settings), size_(size) {}

void Frame::set_scene(const scenes::Scene& scene) {
    const auto corners = static_cast<std::uint32_t>(scene.mesh.corners.size());
    const auto points = static_cast<std::uint32_t>(scene.mesh.points.size());
    if (corners == 0) throw std::runtime_error("the scene has no triangles");
    if (!corners_ || corners_->extent() != corners || points_->extent() != points) {
        corners_.emplace(device_, corners);
        points_.emplace(device_, points);
        colours_.emplace(device_, points);
        shadows_.emplace(device_, size_, corners / 3, settings_.spot ? 2u : 1u, settings_.levels, settings_.pages,
                         settings_.standard, settings_.pairs);
    }
    corners_->write(scene.mesh.corners);
    points_->write(scene.mesh.points);
    colours_->write(scene.mesh.colours);
    scene_ = scene;
}

glift::float4x4 Frame::light() const {
    return settings_.spot ? camera::projection_of(scene_.light, 1)
                          : camera::parallel_projection_of(scene_.light, scene_.light_half_size);
}

eye::Viewpoint Frame::viewpoint() const {
    const float aspect = static_cast<float>(size_.x) / static_cast<float>(size_.y);
    const glift::float3 at =
        settings_.spot ? scene_.light.eye : glift::normalize(scene_.light.eye - scene_.light.target);
    return {camera::projection_of(scene_.view, aspect),
            light(),
            glift::float4(at.x, at.y, at.z, settings_.spot ? 1.0f : 0.0f),
            scene_.view.eye,
            scene_.sky,
            0.3f};
}

void Frame::draw(Method method) {
    const shadows::Settings settings{settings_.bias, settings_.step, settings_.finest, settings_.trilinear,
                                     settings_.cached};
    switch (method) {
    case Method::standard:
        shadows_->draw_with_standard(device_, *corners_, *points_, *colours_, viewpoint(), settings);
        break;
    case Method::adaptive:
        shadows_->draw_with_asm(device_, *corners_, *points_, *colours_, viewpoint(), settings,
                                std::min(settings_.seed, settings_.levels - 1), settings_.rounds);
        break;
    case Method::matched:
        shadows_->draw_with_rmsm(device_, *corners_, *points_, *colours_, viewpoint(), settings);
        break;
    }
}

picture::Picture Frame::picture(View view) const {
    const eye::Picture shown(device_, size_);
    const auto& from = shadows_->picture();
    const auto& tree = shadows_->tree();
    switch (view) {
    case View::picture: return {size_.x, size_.y, from.read(), {}};
    case View::levels: show::show_levels(device_, shadows_->surface(), from, tree, settings_.finest, shown); break;
    case View::borders: show::show_borders(device_, shadows_->surface(), from, tree, settings_.finest, shown); break;
    case View::map: show::show_map(device_, shown, tree, shown); break;
    case View::pool: show::show_pool(device_, shown, tree, shown); break;
    }
    return {size_.x, size_.y, shown.read(), {}};
}

Lighting Frame::lighting() const {
    return {shadows_->surface().read(), shadows_->slopes().read(), shadows_->colour().read(), shadows_->lit().read()};
}

std::string Frame::status() const {
    const auto status = pool();
    const std::uint32_t lost = shadows_->lost().read().front();
    if (lost > 0)
        throw std::runtime_error(std::to_string(lost) +
                                 " pairs of a triangle and a page found no room, so that shadows "
                                 "are missing: give more of them by --pairs");
    std::string text = std::to_string(status.resident) + " of " + std::to_string(status.capacity) + " pages, " +
                       std::to_string(status.granted) + " new, " + std::to_string(status.refused) + " refused";
    if (const std::uint32_t rounds = shadows_->rounds().read().front())
        text += ", " + std::to_string(rounds) + " rounds";
    return text;
}
