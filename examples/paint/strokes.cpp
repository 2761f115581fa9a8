#include "strokes.h"

#include "examples/common/new_file.h"

#include <glift/host/math.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

namespace strokes {

namespace {

using Json = nlohmann::json;
using glift::float2;
using glift::float3;

constexpr float spacing = 0.25f;  ///< of dabs, as a part of the radius
constexpr std::array<const char*, 3> blends = {"over", "multiply", "erase"};

/// What the numbers of a brush may be.
struct Limits {
    float low, high;
    /// The nearest number that is allowed; the smallest one for NaN.
    float nearest(float value) const { return value >= low ? std::min(value, high) : low; }
};
constexpr Limits radii{0.5f, 8192}, parts{0, 1}, counts_of_cells{1, 4096};

[[noreturn]] void refuse(const std::string& what) { throw std::runtime_error(what); }

/// The value of the member `name`: throws unless it is a number from `low` to `high`.
float number(const Json& json, const std::string& name, float low, float high) {
    if (!json.is_number()) refuse("'" + name + "' has to be a number");
    const float value = json.get<float>();
    if (!(value >= low && value <= high)) {
        char text[160];
        std::snprintf(text, sizeof text, "'%s' is %g, and has to be from %g to %g", name.c_str(),
                      static_cast<double>(value), static_cast<double>(low), static_cast<double>(high));
        refuse(text);
    }
    return value;
}

float number(const Json& json, const std::string& name, Limits limits) {
    return number(json, name, limits.low, limits.high);
}

std::vector<float> numbers(const Json& json, const std::string& name, std::size_t count, float low, float high) {
    if (!json.is_array() || json.size() != count)
        refuse("'" + name + "' has to be a list of " + std::to_string(count) + " numbers");
    std::vector<float> values;
    for (const Json& value : json) values.push_back(number(value, name, low, high));
    return values;
}

float3 triple(const Json& json, const std::string& name, float low, float high) {
    const std::vector<float> v = numbers(json, name, 3, low, high);
    return float3(v[0], v[1], v[2]);
}

void check_names(const Json& json, const std::string& what, const std::set<std::string>& names) {
    if (!json.is_object()) refuse("'" + what + "' has to be an object: { … }");
    for (const auto& [name, value] : json.items())
        if (!names.contains(name)) refuse("'" + what + "' has no member '" + name + "'");
}

/// Refuses an `up` that is zero or along the view: it does not say how the picture is turned.
void check_up(const camera::Camera& camera) {
    constexpr float shortest = 1e-6f, least_sine = 1e-4f;
    const float length = glift::length(camera.up);
    if (!(length > shortest)) refuse("'up' has to be a direction");
    const float3 arm = camera.eye - camera.target;
    const float3 right = glift::cross(camera.up * (1 / length), arm * (1 / glift::length(arm)));
    if (!(glift::length(right) > least_sine)) refuse("'up' has to be another direction than that of the view");
}

void read_camera(const Json& json, camera::Camera& camera) {
    check_names(json, "camera", {"eye", "target", "up", "angle", "near", "far"});
    constexpr float far = 1e6f;
    if (json.contains("eye")) camera.eye = triple(json["eye"], "eye", -far, far);
    if (json.contains("target")) camera.target = triple(json["target"], "target", -far, far);
    if (json.contains("up")) camera.up = triple(json["up"], "up", -far, far);
    if (json.contains("angle")) camera.height_angle = number(json["angle"], "angle", 1e-3f, 3.0f);
    if (json.contains("near")) camera.near = number(json["near"], "near", 1e-6f, far);
    if (json.contains("far")) camera.far = number(json["far"], "far", 1e-6f, far);
    if (camera.near >= camera.far) refuse("'near' has to be smaller than 'far'");
    if (camera.eye == camera.target) refuse("'eye' and 'target' have to be two places");
    check_up(camera);
}

glift::uint blend_of(const Json& json) {
    for (glift::uint i = 0; i < blends.size(); ++i)
        if (json == blends[i]) return i;
    refuse("'blend' has to be \"over\", \"multiply\" or \"erase\"");
}

std::string picture_of(const Json& json, const std::filesystem::path& folder) {
    if (!json.is_string()) refuse("'picture' has to be the name of a file");
    const auto name = json.get<std::string>();
    return name.empty() ? name : (folder / name).string();
}

void read_brush(const Json& json, const std::filesystem::path& folder, Brush& brush) {
    check_names(json, "brush",
                {"radius", "hardness", "grain", "opacity", "flow", "cells", "colour", "blend", "picture"});
    if (json.contains("radius")) brush.radius = number(json["radius"], "radius", radii);
    if (json.contains("hardness")) brush.hardness = number(json["hardness"], "hardness", parts);
    if (json.contains("grain")) brush.grain = number(json["grain"], "grain", parts);
    if (json.contains("opacity")) brush.opacity = number(json["opacity"], "opacity", parts);
    if (json.contains("flow")) brush.flow = number(json["flow"], "flow", parts);
    if (json.contains("cells")) brush.cells = number(json["cells"], "cells", counts_of_cells);
    if (json.contains("colour")) brush.colour = triple(json["colour"], "colour", 0, 1);
    if (json.contains("blend")) brush.blend = blend_of(json["blend"]);
    if (json.contains("picture")) brush.picture = picture_of(json["picture"], folder);
}

glift::uint2 size_of(const Json& json) {
    const std::vector<float> size = numbers(json, "size", 2, 1, 16384);
    for (const float side : size)
        if (side != std::floor(side)) refuse("'size' has to be whole numbers of pixels");
    return {static_cast<glift::uint>(size[0]), static_cast<glift::uint>(size[1])};
}

std::vector<Touch> path_of(const Json& json) {
    if (!json.is_array() || json.empty()) refuse("'path' has to be a list of places: [x, y] or [x, y, pressure]");
    std::vector<Touch> path;
    for (const Json& place : json) {
        constexpr float far = 1e6f;
        const bool has_pressure = place.is_array() && place.size() == 3;
        const std::vector<float> v = numbers(place, "path", has_pressure ? 3 : 2, -far, far);
        path.push_back({float2(v[0], v[1]), has_pressure ? number(place[2], "pressure", 0, 1) : 1});
    }
    return path;
}

Stroke stroke_of(const Json& json, const std::filesystem::path& folder, Stroke stroke) {
    check_names(json, "stroke", {"camera", "size", "brush", "path"});
    if (json.contains("camera")) read_camera(json["camera"], stroke.camera);
    if (json.contains("size")) stroke.size = size_of(json["size"]);
    if (json.contains("brush")) read_brush(json["brush"], folder, stroke.brush);
    if (!json.contains("path")) refuse("a stroke has to have a 'path'");
    stroke.path = path_of(json["path"]);
    if (dabs_of(stroke).size() > most_dabs) refuse("'path' is too long for so small a brush");
    return stroke;
}

paint::Brush dab_at(const Brush& brush, const Touch& touch) {
    const float size = 0.5f + 0.5f * touch.pressure;
    return {touch.place,   brush.radius * size, brush.hardness, brush.grain, brush.flow * touch.pressure,
            brush.opacity, brush.cells * size,  brush.colour,   brush.blend};
}

Json json_of(const float3& v) { return {v.x, v.y, v.z}; }

Json json_of(const Stroke& s) {
    Json path = Json::array();
    for (const Touch& touch : s.path) path.push_back({touch.place.x, touch.place.y, touch.pressure});
    const camera::Camera& c = s.camera;
    return {{"camera",
             {{"eye", json_of(c.eye)},
              {"target", json_of(c.target)},
              {"up", json_of(c.up)},
              {"angle", c.height_angle},
              {"near", c.near},
              {"far", c.far}}},
            {"size", {s.size.x, s.size.y}},
            {"brush",
             {{"radius", s.brush.radius},
              {"hardness", s.brush.hardness},
              {"grain", s.brush.grain},
              {"opacity", s.brush.opacity},
              {"flow", s.brush.flow},
              {"cells", s.brush.cells},
              {"colour", json_of(s.brush.colour)},
              {"blend", blends.at(s.brush.blend)},
              {"picture", s.brush.picture.empty() ? "" : std::filesystem::absolute(s.brush.picture).string()}}},
            {"path", std::move(path)}};
}

}  // namespace

Brush allowed(Brush brush) {
    brush.radius = radii.nearest(brush.radius);
    brush.cells = counts_of_cells.nearest(brush.cells);
    for (float* part : {&brush.hardness, &brush.grain, &brush.opacity, &brush.flow, &brush.colour.x, &brush.colour.y,
                        &brush.colour.z})
        *part = parts.nearest(*part);
    return brush;
}

std::vector<paint::Brush> Dabs::to(const Touch& touch) {
    const double apart = std::max(1.0, static_cast<double>(spacing * brush_.radius));
    std::vector<paint::Brush> dabs;
    if (left_ < 0) {
        dabs.push_back(dab_at(brush_, touch));
        left_ = apart;
    } else {
        const double x = static_cast<double>(touch.place.x) - static_cast<double>(last_.place.x),
                     y = static_cast<double>(touch.place.y) - static_cast<double>(last_.place.y),
                     length = std::sqrt(x * x + y * y);
        double along = left_;
        for (; along <= length && dabs.size() <= most_dabs; along += apart) {
            const auto part = static_cast<float>(along / length);
            dabs.push_back(dab_at(brush_, {last_.place + (touch.place - last_.place) * part,
                                           last_.pressure + (touch.pressure - last_.pressure) * part}));
        }
        left_ = along - length;
    }
    last_ = touch;
    return dabs;
}

std::vector<paint::Brush> dabs_of(const Stroke& stroke) {
    Dabs dabs(stroke.brush);
    std::vector<paint::Brush> all;
    for (const Touch& touch : stroke.path) {
        const std::vector<paint::Brush> some = dabs.to(touch);
        all.insert(all.end(), some.begin(), some.end());
        if (all.size() > most_dabs) break;
    }
    return all;
}

surface::Viewpoint viewpoint_of(const camera::Camera& camera, glift::uint2 size) {
    const float width = static_cast<float>(size.x), height = static_cast<float>(size.y);
    return {camera::projection_of(camera, width / height), camera.eye, 2 * std::tan(camera.height_angle / 2) / height,
            float2(width, height)};
}

std::vector<Stroke> read(const std::string& path, Stroke before) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error(path + ": cannot be opened");
    std::vector<Stroke> strokes;
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    std::string line;
    for (unsigned number = 1; std::getline(file, line); ++number) {
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        try {
            before = stroke_of(Json::parse(line), folder, before);
        } catch (const std::exception& error) {
            throw std::runtime_error(path + ", line " + std::to_string(number) + ": " + error.what());
        }
        strokes.push_back(before);
    }
    if (file.bad()) throw std::runtime_error(path + ": cannot be read to its end");
    return strokes;
}

std::string text_of(const std::vector<Stroke>& strokes) {
    std::string text;
    try {
        for (const Stroke& stroke : strokes) text += json_of(stroke).dump() + '\n';
    } catch (const Json::exception&) {  // all else in a stroke is numbers
        refuse("a brush's picture has a name that is not in UTF-8, and no file of strokes can hold it");
    }
    return text;
}

void write(const std::string& path, const std::vector<Stroke>& strokes) {
    const std::string text = text_of(strokes);
    NewFile file(path);
    file.write(text);
    file.take_name();
}

}  // namespace strokes
