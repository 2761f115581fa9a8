// Paths: where camera and light are, frame by frame. They are kept in files, so that a run can be repeated exactly.
#pragma once

#include "examples/common/scenes/scenes.h"

#include <string>
#include <vector>

namespace path {

struct Step {
    float time;  ///< of the scene, in seconds
    camera::Camera view, light;
};

/// How camera and light go around the scene.
struct Way {
    unsigned frames = 1;
    float turn = 1.5707964f / 240;  ///< of the camera to the left, radians a frame; the light turns half as far
    float closer = 1;               ///< how many times closer to the target the last frame is than the first
    bool is_static = false;         ///< scene and light stand still
};
/// The steps of such a way, from `time` on: 1/24 s apart in the scene's time, or, if `is_static`, all at `time`.
std::vector<Step> around(const scenes::Scene& scene, float time, const Way& way);

/// `number` of the steps, spread evenly over all of them, from the first one on; all if `number` is 0 or there are no
/// more.
std::vector<Step> some_of(const std::vector<Step>& steps, std::size_t number);

/// Reads and writes files with a line for each frame: time, camera's eye and target, light's eye and target. A line
/// that begins with # is a comment. All else of the cameras is taken from `scene`. Throw std::runtime_error, which
/// names the file, and of a wrong line its number.
std::vector<Step> read(const std::string& file, const scenes::Scene& scene);
void write(const std::string& file, const std::vector<Step>& steps);

}  // namespace path
