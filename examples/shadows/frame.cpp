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

Filter filter_of(const std::string& name) {
    return choice_of<Filter>(
        name, {{"nearest", Filter::nearest}, {"bilinear", Filter::bilinear}, {"trilinear", Filter::trilinear}});
}

LightKind light_of(const std::string& name) {
    return choice_of<LightKind>(
        name, {{"directional", LightKind::directional}, {"spot", LightKind::spot}, {"point", LightKind::point}});
}

Frame::Frame(glift::Device device, const Settings& settings, glift::uint2 size)
    : device_(std::move(device)), settings_(settings), size_(size) {
    if (settings.light == LightKind::point && (settings.levels < 3 || settings.pages < 6))
        throw std::runtime_error(
            "a point light has six maps in its quadtree: give it at least 3 levels by --levels and "
            "6 pages by --pages");
}

void Frame::set_scene(const scenes::Scene& scene) {
    const auto corners = static_cast<std::uint32_t>(scene.mesh.corners.size());
    const auto points = static_cast<std::uint32_t>(scene.mesh.points.size());
    if (corners == 0) throw std::runtime_error("the scene has no triangles");
    if (!corners_ || corners_->extent() != corners || points_->extent() != points) {
        corners_.emplace(device_, corners);
        points_.emplace(device_, points);
        colours_.emplace(device_, points);
        const auto make = [&]<class Shadows>() {
            shadows_.emplace<Shadows>(device_, size_, corners / 3, settings_.light == LightKind::point ? 6u : 1u,
                                      settings_.light == LightKind::directional ? 1u : 2u, settings_.levels,
                                      settings_.pages, standard_side(), settings_.pairs);
        };
        if (settings_.cells == 16) make.operator()<shadows::Shadows16>();
        else if (settings_.cells == 64) make.operator()<shadows::Shadows64>();
        else make.operator()<shadows::Shadows32>();
        recorded_ = {};
    }
    corners_->write(scene.mesh.corners);
    points_->write(scene.mesh.points);
    colours_->write(scene.mesh.colours);
    scene_ = scene;
}

void Frame::set_knobs(const Settings& settings) {
    const auto knobs = [](const Settings& s) {
        return std::tie(s.bias, s.step, s.finest, s.filter, s.cached, s.rounds);
    };
    if (knobs(settings) == knobs(settings_)) return;
    settings_.bias = settings.bias, settings_.step = settings.step, settings_.finest = settings.finest;
    settings_.filter = settings.filter, settings_.cached = settings.cached, settings_.rounds = settings.rounds;
    recorded_ = {};
}

std::vector<glift::float4x4> Frame::lights() const {
    const camera::Camera& light = scene_.light;
    if (settings_.light == LightKind::directional)
        return {camera::parallel_projection_of(light, scene_.light_half_size)};
    if (settings_.light == LightKind::spot) return {camera::projection_of(light, 1)};
    std::vector<glift::float4x4> faces;
    for (unsigned face = 0; face < 6; ++face)
        faces.push_back(camera::cube_projection_of(light.eye, face, opening(), light.near, light.far));
    return faces;
}

eye::Viewpoint Frame::viewpoint() const {
    const float aspect = static_cast<float>(size_.x) / static_cast<float>(size_.y);
    const bool is_far = settings_.light == LightKind::directional;
    const glift::float3 at = is_far ? glift::normalize(scene_.light.eye - scene_.light.target) : scene_.light.eye;
    return {camera::projection_of(scene_.view, aspect), glift::float4(at.x, at.y, at.z, is_far ? 0.0f : 1.0f),
            scene_.view.eye, scene_.sky, 0.3f};
}

void Frame::prepare(Method method) {
    const std::vector<eye::Viewpoint> view = {viewpoint()};
    with_shadows([&](auto& s) { s.views().write(view), s.lights().write(lights()); });
    glift::Recording& recorded = recorded_.at(static_cast<std::size_t>(method));
    if (recorded) return;
    const std::uint32_t coarsest = settings_.levels - (settings_.light == LightKind::point ? 3 : 1);
    const shadows::Settings settings{.bias = settings_.bias,
                                     .step = settings_.step,
                                     .finest = std::min(settings_.finest, coarsest),
                                     .filter = static_cast<glift::uint>(settings_.filter),
                                     .is_cached = settings_.cached,
                                     .fills_by_kernel = settings_.by_kernel,
                                     .seed = std::min(settings_.seed, coarsest),
                                     .most_rounds = settings_.rounds};
    const glift::uint chosen = method == Method::standard   ? shadows::Method::standard
                               : method == Method::adaptive ? shadows::Method::adaptive
                                                            : shadows::Method::matched;
    recorded = device_.record([&](const glift::Commands& commands) {
        with_shadows([&](auto& s) { s.draw(commands, *corners_, *points_, *colours_, chosen, settings); });
    });
}

void Frame::draw(Method method) {
    prepare(method);
    submit(method);
}

eye::Picture Frame::image(View view) const {
    return with_shadows([&](auto& s) -> eye::Picture {
        if (view == View::picture) return s.picture();
        eye::Picture shown(device_, size_);
        s.show(device_, static_cast<glift::uint>(view), settings_.finest, shown);
        return shown;
    });
}

picture::Picture Frame::picture(View view) const { return {size_.x, size_.y, image(view).read(), {}}; }

Lighting Frame::lighting() const {
    return with_shadows([](auto& s) -> Lighting {
        return {s.surface().read(), s.slopes().read(), s.colour().read(), s.lit().read()};
    });
}

shadows::Status Frame::counts() const {
    return with_shadows([&](auto& s) { return s.status(device_); });
}

std::vector<std::uint32_t> Frame::owners() const {
    return with_shadows([](auto& s) { return s.tree().pages().owners().read(); });
}

std::vector<float> Frame::depths_of_pages() const {
    std::uint32_t width = 0;
    std::vector<float> depths = with_shadows([&](auto& s) {
        const auto& texels = s.tree().frames().texels();
        width = texels.extent().x;
        return texels.read();
    });
    const std::vector<std::uint32_t> owner = owners();
    const std::uint32_t side = settings_.cells + 1, across = width / side;
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const std::size_t frame = i / width / side * across + i % width / side;
        if (frame >= owner.size() || owner[frame] == 0) depths[i] = 0;
    }
    return depths;
}

std::string Frame::status() const {
    const shadows::Status status = counts();
    if (status.lost > 0)
        throw std::runtime_error(std::to_string(status.lost) +
                                 " pairs of a triangle and a page found no room, so that shadows "
                                 "are missing: give more of them by --pairs");
    std::string text = std::to_string(status.asked) + " pages asked for, " + std::to_string(status.pool.resident) +
                       " of " + std::to_string(status.pool.capacity) + " there, " +
                       std::to_string(status.pool.granted) + " new";
    if (status.coarsened > 0) text += ", coarser ones in place of " + std::to_string(status.coarsened);
    if (status.pool.refused > 0) text += ", " + std::to_string(status.pool.refused) + " refused";
    if (status.rounds > 1) text += ", " + std::to_string(status.rounds) + " rounds";
    return text;
}
