// How long a dab of paint takes, from its submission until the device has painted it: a dab that allocates its pages,
// and one whose pages are mostly resident; and how long computing the octree's coarser levels takes at the end of the
// stroke.
#pragma once

#include "examples/paint/canvas.h"

#include <vector>

namespace bench {

/// A part of a stroke. Its times are medians over runs.
struct DabTime {
    const char* name;
    double device = 0;  ///< seconds by timestamps around the recording, before which the device was idle
    double wall = 0;    ///< seconds of the host from submitting the recording to the end of waiting for it
    std::uint64_t submissions = 0, waits = 0;  ///< the most of any run; the wait for the result does not count
    glift::uint new_pages = 0;                 ///< pages that it allocated
};

struct DabCase {
    camera::Camera camera;
    glift::uint side = 1024;  ///< of the stroke's picture, pixels
    float radius = 64;        ///< of the brush, pixels
    int runs = 11;
};

/// Times a dab in the middle of the picture on a model without paint ("first dab"), one a quarter of the radius further
/// ("next dab"), and the end of this stroke ("end"), each as a recording with one submission. Each run begins with
/// nothing painted. Throws std::runtime_error if the pool is too small, or if the camera sees nothing there.
std::vector<DabTime> dab_times(const glift::Device& device, const mesh::Mesh& mesh, const OctreeSize& octree,
                               const DabCase& one);

}  // namespace bench
