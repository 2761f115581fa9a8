#include "shadow_lookups.h"

#include "pass_times.h"

#include "shadow_lookups.glift.hpp"

#include <numeric>
#include <optional>
#include <tuple>

namespace bench {

namespace {

/// The pixels of a frame and a standard map, which is drawn as the example draws its own.
class Pixels {
public:
    explicit Pixels(const Frame& frame)
        : frame_(frame), surface_(frame.device(), frame.size()), slopes_(frame.device(), frame.size()),
          lit_(frame.device(), frame.size()), map_(frame.device(), {frame.standard_side(), frame.standard_side()}) {}

    void take() {
        const glift::Device& device = frame_.device();
        const Lighting lighting = frame_.lighting();
        surface_.write(lighting.surface);
        slopes_.write(lighting.slopes);
        const mesh::Mesh& mesh = frame_.scene().mesh;
        shadow_map::Corners corners(device, static_cast<glift::uint>(mesh.corners.size()));
        shadow_map::Points points(device, static_cast<glift::uint>(mesh.points.size()));
        shadow_map::Lights lights(device, 1);
        corners.write(mesh.corners);
        points.write(mesh.points);
        lights.write(frame_.lights());
        shadow_map::draw_standard(device, corners, points, lights, map_);
        device.wait();
    }
    void by_gather(glift::uint filter) const {
        shadow_lookups::look_up_by_gather(frame_.device(), surface_, slopes_, map_, filter, lit_);
    }
    void by_compare() const { shadow_lookups::look_up_by_compare(frame_.device(), surface_, slopes_, map_, lit_); }
    double mean_lit() const {
        const std::vector<float> lit = lit_.read();
        return std::accumulate(lit.begin(), lit.end(), 0.0) / static_cast<double>(lit.size());
    }

private:
    const Frame& frame_;
    eye::Surface surface_;
    eye::Slopes slopes_;
    shadow_lookups::Lit lit_;
    shadow_map::StandardMap map_;
};

/// Times the second of two executions: the first one may make the pipeline, and brings the map into caches.
template <class LookUp> double seconds_of(PassTimer& timer, const LookUp& look_up) {
    look_up();
    timer.device().wait();
    std::ignore = timer.passes();
    look_up();
    double seconds = 0;
    for (const PassTime& pass : timer.passes()) seconds += pass.seconds;
    return seconds;
}

}  // namespace

LookupTimes lookup_times(const glift::Device& device, const Settings& settings,
                         const std::vector<scenes::Scene>& scenes, glift::uint2 size) {
    PassTimer timer(device);
    LookupTimes found;
    Frame frame(timer.device(), settings, size);
    std::optional<Pixels> pixels;
    for (const scenes::Scene& scene : scenes) {
        frame.set_scene(scene);
        frame.draw(Method::standard);
        if (!pixels) pixels.emplace(frame);
        pixels->take();
        const double share = 1 / static_cast<double>(scenes.size());
        found.nearest += share * seconds_of(timer, [&] { pixels->by_gather(shadow_map::Filter::nearest); });
        found.gather += share * seconds_of(timer, [&] { pixels->by_gather(shadow_map::Filter::bilinear); });
        found.lit_by_gather += share * pixels->mean_lit();
        found.compare += share * seconds_of(timer, [&] { pixels->by_compare(); });
        found.lit_by_compare += share * pixels->mean_lit();
    }
    return found;
}

}  // namespace bench
