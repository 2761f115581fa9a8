// A frame's structures on a device, and the pipelines of shadows.glift that make one.
#pragma once

#include "shadows.glift.hpp"

#include "examples/common/picture.h"
#include "examples/common/scenes/scenes.h"

#include <optional>
#include <string>

enum class Method { standard, adaptive, matched };

/// standard, asm or rmsm.
Method method_of(const std::string& name);

struct Settings {
    std::uint32_t levels = 11, pages = 8192, pairs = 2'000'000, standard = 2048;
    float bias = 5e-5f;
};

class Frame {
public:
    Frame(glift::Device device, const Settings& settings, glift::uint2 size);

    /// The scene of the next frames. As long as the number of points and triangles stays, memory does, too.
    void set_scene(const scenes::Scene& scene);
    /// One submission. Nothing waits.
    void draw(Method method);

    const glift::Device& device() const { return device_; }
    picture::Picture picture() const;
    /// Of the last frame: what the pool has, what was refused. Throws std::runtime_error where depths are missing.
    std::string status() const;

private:
    eye::Viewpoint view() const;

    glift::Device device_;
    Settings settings_;
    shadow_map::ShadowTree tree_;
    shadow_map::StandardMap map_;
    eye::Picture picture_;
    std::optional<shadow_map::Corners> corners_;
    std::optional<shadow_map::Points> points_, colours_;
    scenes::Scene scene_;
};
