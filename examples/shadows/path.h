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

/// A way around the scene's target.
struct Way {
    unsigned frames = 1;
    float turn = 1.5707964f / 240;  ///< of the camera, radians a frame; the light turns half as far
    float closer = 1;               ///< how many times closer to the target the last frame is than the first
    bool is_static = false;         ///< scene and light stand still
};
std::vector<Step> around(const scenes::Scene& scene, float time, const Way& way);

/// So many of these, spread evenly over all of them, the first among them; all if there are no more.
std::vector<Step> some_of(const std::vector<Step>& steps, std::size_t number);

/// A line a frame: time, camera's eye and target, light's eye and target. Throws std::runtime_error with file and line.
std::vector<Step> read(const std::string& file, const scenes::Scene& scene);
void write(const std::string& file, const std::vector<Step>& steps);

}  // namespace path
