#include "paint_dab.h"

#include "median.h"
#include "timing.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <stdexcept>

namespace bench {

namespace {

/// What Canvas (examples/paint) keeps for strokes of one camera, but for the undo history, which a dab does not touch.
class Easel {
public:
    Easel(const glift::Device& device, const mesh::Mesh& mesh, const OctreeSize& size, const DabCase& one)
        : device_(device), size_(size), model_(device, mesh), octree_(device, size.levels(), size.pages),
          journal_(device, size.levels(), size.pages), tip_(device, {1, 1}), surface_(device, {one.side, one.side}),
          normals_(device, {one.side, one.side}), view_(strokes::viewpoint_of(one.camera, {one.side, one.side})) {
        tip_.write(std::vector<float>{1});
    }

    /// Takes all paint away.
    void begin() {
        paint::clear(device_, octree_, size_.ground);
        surface::look(device_, model_.corners(), model_.rest(), model_.rest(), view_, surface_, normals_);
        journal_.clear(device_);
        device_.wait();
    }
    glift::Recording recorded_dab(const paint::Brush& brush) {
        return device_.record([&](const glift::Commands& commands) {
            paint::paint(commands, octree_, journal_, surface_, normals_, view_, brush, tip_, size_.ground);
        });
    }
    glift::Recording recorded_end() {
        return device_.record([&](const glift::Commands& commands) { paint::finish(commands, octree_, journal_); });
    }

    const glift::Device& device() const { return device_; }
    glift::uint pages() const { return octree_.status(device_).resident; }
    glift::uint lost() const { return journal_.lost_pages(device_); }

private:
    glift::Device device_;
    OctreeSize size_;
    Model model_;
    journal::Octree octree_;
    journal::Journal journal_;
    paint::Tip tip_;
    surface::Surface surface_;
    surface::Normals normals_;
    surface::Viewpoint view_;
};

/// A part of the stroke, and its times so far.
struct Part {
    const char* name;
    glift::Recording recording;
    std::vector<double> device, wall;
    DabTime found{};
};

/// Notes the time that a person waits for a part, and its submissions and waits. There are no timestamps, which would
/// add submissions of their own.
void note_wall(const glift::Device& device, Part& part) {
    const glift::Statistics before = device.statistics();
    const auto start = std::chrono::steady_clock::now();
    part.recording.submit();
    const glift::Statistics after = device.statistics();
    device.wait();
    part.wall.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    part.found.submissions = std::max(part.found.submissions, after.submissions - before.submissions);
    part.found.waits = std::max(part.found.waits, after.waits - before.waits);
}

std::vector<Part> parts_of(Easel& easel, const DabCase& one) {
    strokes::Stroke stroke;
    stroke.brush.radius = one.radius;
    const float middle = 0.5f * static_cast<float>(one.side);
    stroke.path = {{{middle, middle}, 1}, {{middle + 0.25f * one.radius + 0.5f, middle}, 1}};
    const std::vector<paint::Brush> dabs = strokes::dabs_of(stroke);
    return {{"first dab", easel.recorded_dab(dabs.at(0)), {}, {}},
            {"next dab", easel.recorded_dab(dabs.at(1)), {}, {}},
            {"end", easel.recorded_end(), {}, {}}};
}

void run_once(Easel& easel, std::vector<Part>& parts, const std::function<void(Part&)>& time) {
    easel.begin();
    for (Part& part : parts) {
        const glift::uint before = easel.pages();
        easel.device().wait();
        time(part);
        part.found.new_pages = easel.pages() - before;
    }
    if (easel.lost() > 0) throw std::runtime_error("the pool is full: give more of them by --pages");
    if (parts[0].found.new_pages == 0) throw std::runtime_error("the first dab painted nothing");
}

/// Runs everything once, which makes the Vulkan pipelines of what run_once() calls besides the recordings (theirs were
/// made when they were recorded). Then repeats it for 100 ms, which raises a GPU's clocks.
void warm_up(Easel& easel, std::vector<Part>& parts) {
    constexpr std::chrono::milliseconds enough(100);
    const auto untimed = [&](Part& part) { part.recording.submit(); };
    run_once(easel, parts, untimed);
    const auto start = std::chrono::steady_clock::now();
    do run_once(easel, parts, untimed);
    while (std::chrono::steady_clock::now() - start < enough);
}

}  // namespace

std::vector<DabTime> dab_times(const glift::Device& device, const mesh::Mesh& mesh, const OctreeSize& octree,
                               const DabCase& one) {
    Easel easel(device, mesh, octree, one);
    std::vector<Part> parts = parts_of(easel, one);
    const auto by_device = [&](Part& part) { part.device.push_back(seconds_of(device, part.recording)); };
    const auto by_wall = [&](Part& part) { note_wall(device, part); };
    warm_up(easel, parts);
    for (int run = 0; run < one.runs; ++run) {
        run_once(easel, parts, by_device);
        run_once(easel, parts, by_wall);
    }
    std::vector<DabTime> times;
    for (Part& part : parts) {
        part.found.name = part.name;
        part.found.device = median(part.device), part.found.wall = median(part.wall);
        times.push_back(part.found);
    }
    return times;
}

}  // namespace bench
