// Strokes: what a brush did along a path before a camera, and files of them, a JSON object a line.
#pragma once

#include "examples/common/camera.h"
#include "paint.glift.hpp"

#include <glift/vector.h>

#include <string>
#include <vector>

namespace strokes {

/// As a person sets it. Colours as screens show them (sRGB).
struct Brush {
    float radius = 24;      ///< in pixels of the stroke's picture
    float hardness = 0.5f;  ///< 0 soft, 1 hard
    float grain = 0;        ///< how much a pattern takes away, 0 to 1
    float opacity = 1;      ///< how much of the colour a stroke leaves, however often it passes, 0 to 1
    float flow = 0.5f;      ///< how much of that one dab leaves, 0 to 1
    float cells = 24;       ///< of the octree along the radius, at least
    glift::float3 colour{0.8f, 0.2f, 0.1f};
    glift::uint blend = paint::Blend::over;
    std::string picture;  ///< a PNG: white leaves all of the colour, black none; empty: the brush is round
};

struct Touch {
    glift::float2 place;  ///< in pixels
    float pressure = 1;   ///< 0 to 1: of the colour, and half of the size
};

struct Stroke {
    camera::Camera camera;
    glift::uint2 size{1024, 1024};  ///< of the picture that was painted in
    Brush brush;
    std::vector<Touch> path;
};

/// Dabs along a path that grows, a quarter of the radius apart, the first one at its beginning.
class Dabs {
public:
    explicit Dabs(const Brush& brush) : brush_(brush) {}
    /// Those from the end of the path to a touch.
    std::vector<paint::Brush> to(const Touch& touch);

private:
    Brush brush_;
    Touch last_;
    double left_ = -1;  ///< to the next dab; below 0: there was no touch
};

/// Those along the whole path.
std::vector<paint::Brush> dabs_of(const Stroke& stroke);

/// What a shader needs of a camera.
surface::Viewpoint viewpoint_of(const camera::Camera& camera, glift::uint2 size);

/// Members that a line leaves out are as in the line before it, but for the path; of the first one as in `before`. A
/// brush's picture is named from the file's folder. Throws std::runtime_error, which
/// names the file, the line and what is wrong.
std::vector<Stroke> read(const std::string& path, Stroke before = {});

/// Every member in each line, floats to the last bit. Throws std::runtime_error.
void write(const std::string& path, const std::vector<Stroke>& strokes);

}  // namespace strokes
