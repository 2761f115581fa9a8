#include "frame.h"

#include <glift/host/math.h>

#include <algorithm>
#include <stdexcept>
#include <tuple>

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
        recorded_ = {};
    }
    corners_->write(scene.mesh.corners);
    points_->write(scene.mesh.points);
    colours_->write(scene.mesh.colours);
    scene_ = scene;
}

void Frame::set_knobs(const Settings& settings) {
    const auto knobs = [](const Settings& s) {
        return std::tie(s.bias, s.step, s.finest, s.trilinear, s.cached, s.rounds);
    };
    if (knobs(settings) == knobs(settings_)) return;
    settings_.bias = settings.bias, settings_.step = settings.step, settings_.finest = settings.finest;
    settings_.trilinear = settings.trilinear, settings_.cached = settings.cached, settings_.rounds = settings.rounds;
    recorded_ = {};
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

void Frame::prepare(Method method) {
    const std::vector<eye::Viewpoint> view = {viewpoint()};
    shadows_->views().write(view);
    glift::Recording& recorded = recorded_.at(static_cast<std::size_t>(method));
    if (recorded) return;
    const bool is_gpu = device_.properties().kind == glift::DeviceKind::gpu;
    const shadows::Settings settings{.bias = settings_.bias,
                                     .step = settings_.step,
                                     .finest = std::min(settings_.finest, settings_.levels - 1),
                                     .is_trilinear = settings_.trilinear,
                                     .is_cached = settings_.cached,
                                     .fills_by_kernel = settings_.by_kernel.value_or(is_gpu),
                                     .seed = std::min(settings_.seed, settings_.levels - 1),
                                     .most_rounds = settings_.rounds};
    const glift::uint chosen = method == Method::standard   ? shadows::Method::standard
                               : method == Method::adaptive ? shadows::Method::adaptive
                                                            : shadows::Method::matched;
    recorded = device_.record([&](const glift::Commands& commands) {
        shadows_->draw(commands, *corners_, *points_, *colours_, chosen, settings);
    });
}

void Frame::draw(Method method) {
    prepare(method);
    submit(method);
}

eye::Picture Frame::image(View view) const {
    const auto& from = shadows_->picture();
    if (view == View::picture) return from;
    const eye::Picture shown(device_, size_);
    const auto& tree = shadows_->tree();
    if (view == View::map) show::show_map(device_, shown, tree, shown);
    else if (view == View::pool) show::show_pool(device_, shown, tree, shown);
    else show::show_pages(device_, shadows_->surface(), from, tree, settings_.finest, view == View::borders, shown);
    return shown;
}

picture::Picture Frame::picture(View view) const { return {size_.x, size_.y, image(view).read(), {}}; }

Lighting Frame::lighting() const {
    return {shadows_->surface().read(), shadows_->slopes().read(), shadows_->colour().read(), shadows_->lit().read()};
}

std::vector<float> Frame::depths_of_pages() const {
    const auto& texels = shadows_->tree().frames().texels();
    std::vector<float> depths = texels.read();
    const std::vector<std::uint32_t> owner = owners();
    constexpr std::uint32_t side = 33;
    const std::uint32_t width = texels.extent().x, across = width / side;
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const std::size_t frame = i / width / side * across + i % width / side;
        if (frame >= owner.size() || owner[frame] == 0) depths[i] = 0;
    }
    return depths;
}

std::string Frame::status() const {
    const auto status = pool();
    const std::uint32_t lost = shadows_->lost().read().front();
    if (lost > 0)
        throw std::runtime_error(std::to_string(lost) +
                                 " pairs of a triangle and a page found no room, so that shadows "
                                 "are missing: give more of them by --pairs");
    std::string text = std::to_string(shadows_->asked().read().front()) + " pages asked for, " +
                       std::to_string(status.resident) + " of " + std::to_string(status.capacity) + " there, " +
                       std::to_string(status.granted) + " new";
    if (const std::uint32_t rounds = shadows_->rounds().read().front(); rounds > 1)
        text += ", " + std::to_string(rounds) + " rounds";
    return text;
}
