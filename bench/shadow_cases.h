// Frames of examples/shadows along a recorded path, timed on a device.
#pragma once

#include "pass_times.h"

#include "examples/shadows/frame.h"
#include "examples/shadows/path.h"

#include <optional>
#include <string>
#include <vector>

namespace bench {

/// A way to make frames: a method, and settings.
struct ShadowCase {
    std::string name;
    Method method;
    Settings settings;
    bool is_static = false;  ///< scene and light stand still, and pages are kept
};

/// All cases that bench_shadows knows: with these settings, or with some of them changed.
std::vector<ShadowCase> shadow_cases(const Settings& settings);

struct ShadowFrames {
    std::vector<double> seconds;  ///< of each frame, by device timestamps; of a static case without the first one
    /// Numbers of pages of each of these frames: resident; new; for which the pool had no room.
    std::vector<std::uint32_t> pages, granted, refused;
    /// Of each of these frames, as in shadows::Status: pages asked for; those of them that have a coarser page in their
    /// place, since the pool is too small; how often pages were filled.
    std::vector<std::uint32_t> asked, coarsened, rounds;
    std::optional<double> touched;  ///< share of the texels of resident pages that pixels look up, median of every
                                    ///< fifth frame; absent for standard maps and static cases
    std::uint64_t texels_a_page = 0, capacity = 0;
    std::uint64_t submissions = 0, waits = 0;  ///< the most of any frame
    std::vector<PassTime> passes;              ///< means over the frames; empty on the host device
};

/// The scenes of a path, which take a while to make.
std::vector<scenes::Scene> scenes_along(const std::string& name, const std::vector<path::Step>& steps);

/// Times each frame of a path `runs` times, and takes the median; also counts pages and, in cases that are not static,
/// the texels that are looked up, and times passes. Throws std::runtime_error if depths are missing (Frame::status).
ShadowFrames measure(const glift::Device& device, const ShadowCase& one, const std::vector<scenes::Scene>& along,
                     glift::uint2 size, unsigned runs);

}  // namespace bench
