// Strokes: a brush, a camera, and a path in the camera's picture along which the brush paints; and files of strokes, a
// JSON object a line. A dab is one print of the brush.
#pragma once

#include "examples/common/camera.h"
#include "paint.glift.hpp"

#include <glift/vector.h>

#include <string>
#include <vector>

namespace strokes {

/// A brush as a person sets it. Its colour is as screens show it (sRGB).
struct Brush {
    float radius = 24;      ///< in pixels of the stroke's picture
    float hardness = 0.5f;  ///< 0 soft, 1 hard
    float grain = 0;        ///< how much a noise pattern weakens the paint: 0 not at all, 1 down to nothing in places
    float opacity = 1;      ///< how much of the colour a stroke leaves, however often it passes, 0 to 1
    float flow = 0.5f;      ///< how much of the stroke's colour one dab leaves at its middle, 0 to 1
    float cells = 24;       ///< a dab paints on the octree's coarsest level on which the radius has so many cells
    glift::float3 colour{0.8f, 0.2f, 0.1f};
    glift::uint blend = paint::Blend::over;
    std::string picture;  ///< a PNG: white leaves all of the colour, black none; empty: the brush is round
};

/// Returns the brush with each number clamped to the range that files of strokes allow. NaN becomes the least number.
Brush allowed(Brush brush);

struct Touch {
    glift::float2 place;  ///< in pixels
    float pressure = 1;   ///< 0 to 1: multiplies the flow; the dab's radius is half the brush's at 0, all of it at 1
};

struct Stroke {
    camera::Camera camera;
    glift::uint2 size{1024, 1024};  ///< of the picture in which the path is
    Brush brush;
    std::vector<Touch> path;
};

/// A stroke with more dabs than this is refused by `read`.
constexpr std::size_t most_dabs = 100000;

/// Makes the dabs of a path as the path grows: the first one at its beginning, the others a quarter of the radius
/// apart, a pixel at least.
class Dabs {
public:
    explicit Dabs(const Brush& brush) : brush_(brush) {}
    /// Extends the path to a touch, and returns the dabs of the new part.
    std::vector<paint::Brush> to(const Touch& touch);

private:
    Brush brush_;
    Touch last_;
    double left_ = -1;  ///< distance from `last_` to the next dab, in pixels; below 0: there was no touch yet
};

/// The dabs along a stroke's whole path. If there are more than most_dabs, only the first ones, but still more than
/// most_dabs of them, so that a caller can tell.
std::vector<paint::Brush> dabs_of(const Stroke& stroke);

/// Converts the camera to the Viewpoint of surface.glift, for pictures of this size.
surface::Viewpoint viewpoint_of(const camera::Camera& camera, glift::uint2 size);

/// Reads a file. A line may leave out all members but the path: they are then as in the line before it, and in the
/// first line as in `before`. A brush's picture is named relative to the file's folder. Throws std::runtime_error,
/// which names the file, the line and what is wrong.
std::vector<Stroke> read(const std::string& path, Stroke before = {});

/// The lines of a file: every member in each line, and floats with so many digits that reading gives the same bits.
/// Throws std::runtime_error if the name of a brush's picture is not in UTF-8.
std::string text_of(const std::vector<Stroke>& strokes);

/// Writes the text of these strokes to a file. An old file of that name stays as it is until the new one is complete,
/// and is then replaced (NewFile). Throws std::runtime_error if the file cannot be written, or as text_of does.
void write(const std::string& path, const std::vector<Stroke>& strokes);

}  // namespace strokes
