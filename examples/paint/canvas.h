// A model and its paint, in an adaptive octree (journal.glift), on a device.
#pragma once

#include "examples/common/mesh.h"
#include "examples/common/npy.h"
#include "examples/common/picture.h"
#include "history.h"
#include "journal.glift.hpp"
#include "paint.glift.hpp"
#include "painted.glift.hpp"
#include "shown.glift.hpp"
#include "strokes.h"
#include "surface.glift.hpp"

#include <map>
#include <optional>
#include <string>

/// How a canvas is made: the size of its octree and of its history, and its ground.
struct OctreeSize {
    glift::uint resolution = 2048;              ///< cells along each side at the finest level: a power of two
    glift::uint pages = 4096;                   ///< how many pages may be resident at once
    glift::float3 ground{0.75f, 0.72f, 0.66f};  ///< the colour where nothing is painted, as screens show it (sRGB)
    HistoryBudget history;

    glift::uint levels() const;
};

/// A mesh on a device, with two positions of each point: at rest, by which paint is stored, and where it is drawn now.
class Model {
public:
    Model(const glift::Device& device, const mesh::Mesh& mesh);
    void pose(const std::vector<glift::float3>& points);

    const surface::Corners& corners() const { return corners_; }
    const surface::Points& rest() const { return rest_; }
    const surface::Points& posed() const { return posed_; }

private:
    surface::Corners corners_;
    surface::Points rest_, posed_;
};

/// The background's colour, linear.
constexpr glift::float3 sky{0.09f, 0.10f, 0.12f};

/// The unit vector towards the light, which moves with the camera: above it and to its left.
glift::float3 light_of(const camera::Camera& camera);

class Canvas {
public:
    Canvas(glift::Device device, const mesh::Mesh& mesh, const OctreeSize& size);

    /// Paints a stroke, and adds it to the history. Nothing is read back before the history reads which pages have
    /// changed: until then one submission may have many dabs. Returns how many requests for pages failed because the
    /// pool was full: these pages are not painted.
    glift::uint paint(const strokes::Stroke& stroke);
    /// The same in parts, for a stroke whose path still grows: `begin` uses its camera, the size of what the camera
    /// sees (Stroke::size) and its brush, but not its path; `dab` is called for each dab; `end` returns what `paint`
    /// does. `begin` throws std::runtime_error if the brush's PNG cannot be read, or is not 2 to 4096 pixels wide and
    /// at most 4096 high.
    void begin(const strokes::Stroke& stroke);
    void dab(const paint::Brush& brush);
    glift::uint end();
    /// Reads a brush's picture ahead of `begin`, so that errors of the picture are thrown here and not by `begin`.
    void prepare(const strokes::Brush& brush) { tip_of(brush.picture); }
    bool undo() { return history_.undo(device_, octree_); }
    bool redo() { return history_.redo(device_, octree_); }
    void save(const std::string& path);
    void load(const std::string& path);  ///< replaces all paint, and clears the history
    picture::Picture render(const camera::Camera& camera, glift::uint2 size, painted::Layers layers = {});
    void render(const camera::Camera& camera, painted::Layers layers, const shown::Shown& to);

    const glift::Device& device() const { return device_; }
    Model& model() { return model_; }
    journal::Octree& octree() { return octree_; }
    /// Samples of the paint on a grid over [0, 1]^3: the channels red, green, blue, alpha are
    /// contiguous, then x, y, z. NumPy sees the shape (z, y, x, channel).
    npy::Array samples(glift::uint side) const;

    struct Bytes {
        std::uint64_t pool = 0, table = 0;
    };
    Bytes bytes() const;
    glift::uint pages() const { return octree_.status(device_).resident; }
    const glift::float3& ground() const { return size_.ground; }
    const History& history() const { return history_; }

private:
    const paint::Tip& tip_of(const std::string& picture);
    void render(const camera::Camera& camera, painted::Layers layers, const painted::Film& film);

    glift::Device device_;
    OctreeSize size_;
    Model model_;
    journal::Octree octree_;
    journal::Journal journal_;
    History history_;
    std::map<std::string, paint::Tip> tips_;  ///< pictures of brushes that were read, by the names of their files
    paint::Tip tip_;                          ///< that of the current stroke's brush
    surface::Viewpoint view_;                 ///< the current stroke's camera
    surface::Surface surface_;
    surface::Normals normals_;
};
