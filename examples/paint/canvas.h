// A model and its paint on a device.
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

/// What an octree is made with.
struct OctreeSize {
    glift::uint resolution = 2048;  ///< cells along each side: a power of two
    glift::uint pages = 4096;       ///< that there may be
    glift::float3 ground{0.75f, 0.72f, 0.66f};
    HistoryBudget history;

    glift::uint levels() const;
};

/// A mesh on a device: where its points rest, which is where paint is kept, and where they are now.
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

/// Linear.
constexpr glift::float3 sky{0.09f, 0.10f, 0.12f};

/// Towards the light that goes with a camera: from above its left shoulder.
glift::float3 light_of(const camera::Camera& camera);

class Canvas {
public:
    Canvas(glift::Device device, const mesh::Mesh& mesh, const OctreeSize& size);

    /// One submission for the camera, one for each dab, one for the coarser levels. Gives how many requests for pages
    /// found no room: there is no paint there.
    glift::uint paint(const strokes::Stroke& stroke);
    /// The same in parts: the camera and the size of the picture, dabs, the end. The beginning throws
    /// std::runtime_error where the brush's picture cannot be read.
    void begin(const strokes::Stroke& stroke);
    void dab(const paint::Brush& brush);
    glift::uint end();
    bool undo() { return history_.undo(device_, octree_); }
    bool redo() { return history_.redo(device_, octree_); }
    void save(const std::string& path);
    void load(const std::string& path);  ///< what can be undone is forgotten
    picture::Picture render(const camera::Camera& camera, glift::uint2 size, painted::Layers layers = {});
    void render(const camera::Camera& camera, painted::Layers layers, const shown::Shown& to);

    const glift::Device& device() const { return device_; }
    Model& model() { return model_; }
    journal::Octree& octree() { return octree_; }
    /// Samples on a grid over [0, 1]^3: red, green, blue and alpha along the first axis, then x, y, z.
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
    std::map<std::string, paint::Tip> tips_;  ///< by the names of their files
    paint::Tip tip_;                          ///< of the stroke
    surface::Viewpoint view_;                 ///< of the stroke
    surface::Surface surface_;
    surface::Normals normals_;
};
