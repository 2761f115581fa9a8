#include "path.h"

#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace path {

namespace {

constexpr float frame_time = 1.0f / 24;

}  // namespace

std::vector<Step> around(const scenes::Scene& scene, float time, const Way& way) {
    std::vector<Step> steps;
    for (unsigned i = 0; i < way.frames; ++i) {
        const auto k = static_cast<float>(i);
        const float part = way.frames > 1 ? k / static_cast<float>(way.frames - 1) : 0, passed = way.is_static ? 0 : k;
        steps.push_back({time + frame_time * passed,
                         camera::orbited(scene.view, -way.turn * k, 0, std::pow(way.closer, part)),
                         camera::orbited(scene.light, -0.5f * way.turn * passed, 0, 1)});
    }
    return steps;
}

std::vector<Step> some_of(const std::vector<Step>& steps, std::size_t number) {
    if (number == 0 || number >= steps.size()) return steps;
    std::vector<Step> some;
    for (std::size_t i = 0; i < number; ++i) some.push_back(steps[i * steps.size() / number]);
    return some;
}

std::vector<Step> read(const std::string& file, const scenes::Scene& scene) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error(file + ": cannot be read");
    std::vector<Step> steps;
    std::string line;
    for (unsigned number = 1; std::getline(in, line); ++number) {
        if (line.empty() || line[0] == '#') continue;
        Step step{0, scene.view, scene.light};
        std::istringstream words(line);
        words >> step.time;
        for (glift::float3* v : {&step.view.eye, &step.view.target, &step.light.eye, &step.light.target})
            words >> v->x >> v->y >> v->z;
        std::string rest;
        if (!words || words >> rest)
            throw std::runtime_error(file + ":" + std::to_string(number) +
                                     ": has to have 13 numbers: time, camera's eye and target, light's eye and target");
        if (step.view.eye == step.view.target || step.light.eye == step.light.target)
            throw std::runtime_error(file + ":" + std::to_string(number) +
                                     ": an eye is at its target, so that it looks nowhere");
        steps.push_back(step);
    }
    if (steps.empty()) throw std::runtime_error(file + ": has no frames");
    return steps;
}

void write(const std::string& file, const std::vector<Step>& steps) {
    std::ofstream out(file);
    out << "# time, camera's eye and target, light's eye and target\n" << std::setprecision(9);
    for (const Step& step : steps) {
        out << step.time;
        for (const glift::float3& v : {step.view.eye, step.view.target, step.light.eye, step.light.target})
            out << ' ' << v.x << ' ' << v.y << ' ' << v.z;
        out << '\n';
    }
    if (!out.flush()) throw std::runtime_error(file + ": cannot be written");
}

}  // namespace path
