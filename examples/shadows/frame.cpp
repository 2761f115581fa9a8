#include "frame.h"

#include <glift/host/math.h>

#include <algorithm>
#include <cmath>
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

std::string text_of(const shadows::Status& status, Method method) {
    if (method == Method::standard) return "";
    std::string text = std::to_string(status.asked) + " pages asked for, " + std::to_string(status.pool.resident) +
                       " of " + std::to_string(status.pool.capacity) + " there";
    if (method == Method::matched) text += ", " + std::to_string(status.pool.granted) + " new";
    else text += ", " + std::to_string(status.rounds) + " rounds";
    if (status.coarsened > 0) text += ", coarser ones in place of " + std::to_string(status.coarsened);
    if (status.pool.refused > 0) text += ", " + std::to_string(status.pool.refused) + " refused";
    return text;
}

std::string text_of_lost(const shadows::Status& status) {
    return std::to_string(status.lost) + " pairs of a triangle and a page found no room, so that shadows are missing: "
                                         "give more of them by --pairs";
}

Frame::Frame(glift::Device device, const Settings& settings, glift::uint2 size)
    : device_(std::move(device)), settings_(settings), size_(size) {
    if (settings.light == LightKind::point && (quadtree_levels() > most_levels || settings.pages < 6))
        throw std::runtime_error("a point light has six maps in its quadtree: give it at most " +
                                 std::to_string(most_levels - 2) +
                                 " levels by --levels and at least 6 pages by --pages");
}

void Frame::set_scene(const scenes::Scene& scene) {
    if (scene.mesh.corners.empty()) throw std::runtime_error("the scene has no triangles");
    const bool has_moved = scene.mesh != scene_.mesh;
    const bool is_lit_anew = scene.light != scene_.light || scene.light_half_size != scene_.light_half_size;
    if (has_moved) write_mesh(scene.mesh);
    scene_.view = scene.view, scene_.light = scene.light;
    scene_.light_half_size = scene.light_half_size, scene_.sky = scene.sky;
    if (!has_moved && !is_lit_anew) return;
    light_ = fitted_light(scene_, settings_.light, opening());
    for (Made& made : made_) made.is_stale = true;
}

void Frame::write_mesh(const mesh::Mesh& mesh) {
    const auto corners = static_cast<std::uint32_t>(mesh.corners.size());
    const auto points = static_cast<std::uint32_t>(mesh.points.size());
    if (!corners_ || corners_->extent() != corners || points_->extent() != points) {
        corners_.emplace(device_, corners);
        points_.emplace(device_, points);
        colours_.emplace(device_, points);
        made_ = {};
    }
    corners_->write(mesh.corners);
    points_->write(mesh.points);
    colours_->write(mesh.colours);
    scene_.mesh = mesh;
}

void Frame::set_knobs(const Settings& settings) {
    const auto knobs = [](const Settings& s) { return std::tie(s.step, s.finest, s.filter, s.cached, s.rounds); };
    settings_.bias = settings.bias;
    if (knobs(settings) == knobs(settings_)) return;
    settings_.step = settings.step, settings_.finest = settings.finest;
    settings_.filter = settings.filter, settings_.cached = settings.cached, settings_.rounds = settings.rounds;
    for (Made& made : made_) made.recorded = {};
}

float Frame::opening() const {
    if (settings_.light == LightKind::spot) return std::tan(scene_.light.height_angle / 2);
    return 1 + 2.0f / static_cast<float>(standard_side() - 2);
}

std::vector<glift::float4x4> Frame::lights() const {
    if (settings_.light == LightKind::directional)
        return {camera::parallel_projection_of(light_, scene_.light_half_size)};
    if (settings_.light == LightKind::spot) return {camera::projection_of(light_, 1)};
    std::vector<glift::float4x4> faces;
    for (unsigned face = 0; face < 6; ++face)
        faces.push_back(camera::cube_projection_of(light_.eye, face, opening(), light_.near, light_.far));
    return faces;
}

eye::Viewpoint Frame::viewpoint() const {
    const float aspect = static_cast<float>(size_.x) / static_cast<float>(size_.y);
    const bool is_far = settings_.light == LightKind::directional;
    const glift::float3 at = is_far ? glift::normalize(scene_.light.eye - scene_.light.target) : scene_.light.eye;
    return {camera::projection_of(scene_.view, aspect),
            glift::float4(at.x, at.y, at.z, is_far ? 0.0f : 1.0f),
            scene_.view.eye,
            scene_.sky,
            0.3f,
            settings_.bias * (is_far ? 1.0f : light_.near * light_.far)};
}

Frame::Structures Frame::make_structures() const {
    const auto make = [&]<class Shadows>() -> Structures {
        return Shadows(device_, size_, corners_->extent() / 3, settings_.light == LightKind::point ? 6u : 1u,
                       settings_.light == LightKind::directional ? 1u : 2u, quadtree_levels(), settings_.pages,
                       standard_side(), settings_.pairs);
    };
    if (settings_.cells == 16) return make.operator()<shadows::Shadows16>();
    if (settings_.cells == 64) return make.operator()<shadows::Shadows64>();
    return make.operator()<shadows::Shadows32>();
}

void Frame::prepare(Method method) {
    last_ = method;
    Made& made = made_.at(static_cast<std::size_t>(method));
    if (std::holds_alternative<std::monostate>(made.structures)) made = {make_structures(), {}, false, false};
    const std::vector<eye::Viewpoint> view = {viewpoint()};
    with_shadows([&](auto& s) { s.views().write(view), s.lights().write(lights()); });
    const bool keeps = settings_.cached && !made.is_stale;
    if (made.recorded && made.keeps == keeps) return;
    made.keeps = keeps;
    made.recorded = record(method, keeps);
}

glift::Recording Frame::record(Method method, bool keeps) const {
    const shadows::Settings settings{.step = settings_.step,
                                     .finest = std::min(settings_.finest, coarsest()),
                                     .filter = static_cast<glift::uint>(settings_.filter),
                                     .is_cached = keeps,
                                     .fills_by_kernel = settings_.by_kernel,
                                     .seed = std::min(settings_.seed, coarsest()),
                                     .most_rounds = settings_.rounds};
    const glift::uint chosen = method == Method::standard   ? shadows::Method::standard
                               : method == Method::adaptive ? shadows::Method::adaptive
                                                            : shadows::Method::matched;
    return device_.record([&](const glift::Commands& commands) {
        with_shadows([&](auto& s) { s.draw(commands, *corners_, *points_, *colours_, chosen, settings); });
    });
}

void Frame::submit(Method method) {
    Made& made = made_.at(static_cast<std::size_t>(method));
    made.recorded.submit();
    made.is_stale = false;
}

void Frame::draw(Method method) {
    prepare(method);
    submit(method);
}

eye::Picture Frame::image(View view) const {
    return with_shadows([&](auto& s) -> eye::Picture {
        if (view == View::picture) return s.picture();
        eye::Picture shown(device_, size_);
        s.show(device_, static_cast<glift::uint>(view), std::min(settings_.finest, coarsest()), shown);
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
    return with_shadows([](auto& s) { return s.status().read().front(); });
}

glift::Download Frame::download_counts() const {
    return with_shadows([&](auto& s) {
        return glift::Commands(device_).download(s.status().row_memory(), 0, sizeof(shadows::Status));
    });
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
    if (status.lost > 0) throw std::runtime_error(text_of_lost(status));
    return text_of(status, last_);
}
