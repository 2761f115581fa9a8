// Where camera and light are, frame by frame: in files, so that a run can be repeated exactly.
#pragma once

#include "examples/common/scenes/scenes.h"

#include <string>
#include <vector>

namespace path {

struct Step {
    float time;  ///< of the scene, in seconds
    camera::Camera view, light;
};

/// Around the scene's target from its own view, a quarter of a turn in 240 frames; the light moves half as far.
std::vector<Step> around(const scenes::Scene& scene, float time, unsigned frames, bool is_static);

/// A line a frame: time, camera's eye and target, light's eye and target. Throws std::runtime_error with file and line.
std::vector<Step> read(const std::string& file, const scenes::Scene& scene);
void write(const std::string& file, const std::vector<Step>& steps);

}  // namespace path
