// Goes through scenes along their recorded paths, frame by frame.
#pragma once

#include "frame.h"
#include "path.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <vector>

struct Walk {
    std::vector<std::string> scenes = {"hairball", "robot", "skeletons", "city", "trees"};
    std::string paths = "examples/shadows/paths";  ///< a folder with a path file for each scene
    std::string prefix;                            ///< of the names of these files
    std::size_t frames = 0;                        ///< at most so many of each path, spread evenly; 0: all
    bool only_first = false;                       ///< `frames` takes the first steps, not evenly spread ones
    glift::uint2 size{1024, 1024};
    Settings settings;

    /// The frames of a scene's path. Throws std::runtime_error, which names the file.
    std::vector<path::Step> steps_of(const std::string& scene) const;
    /// Calls `visit` with each frame of a scene, ready to be drawn, and its number. Throws std::runtime_error where
    /// pages are to be kept but the scene or the light moves.
    void over(const std::string& scene, const glift::Device& device,
              const std::function<void(Frame&, std::size_t)>& visit) const;
};

/// {"least": …, "middle": …, "mean": …, "most": …} of at least one value.
nlohmann::ordered_json spread_of(std::vector<double> values);

/// A file of JSON values, a line each. Throws std::runtime_error where it cannot be written.
class JsonLines {
public:
    explicit JsonLines(std::string path);
    void add(const nlohmann::ordered_json& value);

private:
    std::string path_;
};
