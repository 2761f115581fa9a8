// Generated scenes, which look the same on every machine and move with time. y is up; the ground is near y = 0.
#pragma once

#include "examples/common/camera.h"
#include "examples/common/mesh.h"

#include <string>
#include <vector>

namespace scenes {

struct Scene {
    mesh::Mesh mesh;
    camera::Camera view;
    camera::Camera light;          ///< directional: from its eye to its target
    float light_half_size = 1.0f;  ///< half the side of the square that the light's parallel projection shows
    glift::float3 sky{0.6f, 0.75f, 0.9f};
};

/// The names of the scenes: hairball, fence, robot, skeletons, city, trees.
const std::vector<std::string>& names();

/// The scene at a time, in seconds. Throws std::runtime_error, which lists the names, if there is no such scene.
Scene make(const std::string& name, float time = 0.0f);

// The scenes, each in a file of its own.
Scene hairball(float time);   ///< 4,000 hairs of 12 segments before a wall; they sway
Scene fence(float time);      ///< a fence with flags, behind it a meadow and mountains; the flags wave
Scene robot(float time);      ///< a robot that walks on the spot between crates
Scene skeletons(float time);  ///< nine skeletons that dance
Scene city(float time);       ///< 400 houses, between them cars that drive
Scene trees(float time);      ///< trees with leaves on a lawn; they sway

}  // namespace scenes
