#include "walk.h"

#include <algorithm>
#include <fstream>
#include <numeric>
#include <stdexcept>

namespace {

bool are_same(const glift::float3& a, const glift::float3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/// Whether scene and light are the same in two steps, so that at most the camera moves.
bool stand_still(const path::Step& before, const path::Step& now) {
    return before.time == now.time && are_same(before.light.eye, now.light.eye) &&
           are_same(before.light.target, now.light.target);
}

}  // namespace

std::vector<path::Step> Walk::steps_of(const std::string& scene) const {
    const std::string file = paths + "/" + prefix + scene + ".path";
    std::vector<path::Step> steps = path::read(file, scenes::make(scene));
    if (!only_first) return path::some_of(steps, frames);
    if (frames > 0 && frames < steps.size()) steps.resize(frames);
    return steps;
}

void Walk::over(const std::string& scene, const glift::Device& device,
                const std::function<void(Frame&, std::size_t)>& visit) const {
    const std::vector<path::Step> steps = steps_of(scene);
    Frame frame(device, settings, size);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (i > 0 && stand_still(steps[i - 1], steps[i])) {
            frame.set_view(steps[i].view);
        } else {
            if (i > 0 && settings.cached)
                throw std::runtime_error(scene + ": pages cannot be kept (--cached) on a path on which the scene or "
                                                 "the light moves");
            scenes::Scene at = scenes::make(scene, steps[i].time);
            at.view = steps[i].view, at.light = steps[i].light;
            frame.set_scene(at);
        }
        visit(frame, i);
    }
}

nlohmann::ordered_json spread_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    const double middle = values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2;
    return {{"least", values.front()},
            {"middle", middle},
            {"mean", std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size())},
            {"most", values.back()}};
}

JsonLines::JsonLines(std::string path) : path_(std::move(path)) {
    if (!std::ofstream(path_)) throw std::runtime_error(path_ + ": cannot be written");
}

void JsonLines::add(const nlohmann::ordered_json& value) {
    std::ofstream out(path_, std::ios::app);
    out << value.dump() << "\n";
    if (!out.flush()) throw std::runtime_error(path_ + ": cannot be written");
}
